// SPDX-License-Identifier: Apache-2.0
// Refused lists: networks that do not hold together, and files that are no list.
#include <gtest/gtest.h>

#include "refused.hpp"

namespace rung {
namespace {

class RefusedStructure : public testing::TestWithParam<Refused> {};

TEST_P(RefusedStructure, SaysWhereWhatAndHowToMend) { expect_refused(GetParam()); }

constexpr Refused kStructure[] = {
    {"ContactFirst", "AND X0\nOUT Y0\nLD X1\nOUT Y1\nEND", std::nullopt,
     "t:1:1: error: AND has no result to work on: no LD or LDI before it\n"
     "    begin the network with LD or LDI instead\n"},
    {"OutputFirst", "NOP\nOUT Y0\nLD X1\nOUT Y1\nEND", std::nullopt,
     "t:2:1: error: OUT has no result to work on: no LD or LDI before it\n"
     "    begin the network with LD or LDI\n"},
    {"BranchFirst", "MPS\nOUT Y0\nEND", std::nullopt,
     "t:1:1: error: MPS has no result to work on: no LD or LDI before it\n"
     "    begin the network with LD or LDI\n"},
    {"OneBlock", "LD X0\nANB\nOUT Y0\nLD X1\nOUT Y1\nORB\nOUT Y2\nEND", std::nullopt,
     "t:2:1: error: ANB joins two blocks, but only the one of LD at line 1 is open\n"
     "    each block begins with its own LD or LDI; after an output begin a branch with MPS\n"
     "t:6:1: error: ORB joins two blocks, but only the one of LD at line 4 is open\n"
     "    each block begins with its own LD or LDI; after an output begin a branch with MPS\n"},
    {"NoBlock", "ORB\nOUT Y2\nEND", std::nullopt,
     "t:1:1: error: ORB has no result to work on: no LD or LDI before it\n"
     "    begin the network with LD or LDI\n"},
    {"BlockLeftOpen", "LD X0\nLD X1\nOUT Y0\nLD X2\nMPP\nOUT Y1\nEND", std::nullopt,
     "t:3:1: error: OUT uses the block of LD at line 2, which nothing joins with the one of LD at "
     "line 1\n"
     "    join them with ANB (in series) or ORB (in parallel) before this output\n"
     "t:5:1: error: MPP without MPS: no branch is open in this network\n"
     "    put MPS where the branches part, before the first of them\n"},
    {"BlockAfterAnOutput", "LD X0\nOUT Y0\nLD X1\nOR X2\nANB\nOUT Y1\nEND", std::nullopt,
     "t:5:1: error: ANB joins two blocks, but only the one of LD at line 3 is open\n"
     "    each block begins with its own LD or LDI; after an output begin a branch with MPS\n"},
    {"BranchLeftOpen", "LD X0\nMPS\nAND X1\nOUT Y0\nLD X2\nOUT Y1\nLD X3\nOUT Y2\nEND",
     std::nullopt,
     "t:6:1: error: OUT uses the block of LD at line 5, which nothing joins with the one of LD at "
     "line 1\n"
     "    join them with ANB (in series) or ORB (in parallel) before this output\n"
     "t:2:1: note: the branch of this MPS is still open: if the network ends before that LD, its "
     "last branch needs MPP\n"},
    {"BranchOpenAtTheEnd", "LD X0\nMPS\nAND X1\nOUT Y0\nEND", std::nullopt,
     "t:2:1: error: MPS without MPP: the branch is still open at the end of the network\n"
     "    read the last branch with MPP instead of MRD\n"},
    {"NoBranch", "LD X0\nMRD\nOUT Y0\nLD X1\nMPS\nOUT Y0\nMPP\nOUT Y1\nMPP\nOUT Y2\nEND",
     std::nullopt,
     "t:2:1: error: MRD without MPS: no branch is open in this network\n"
     "    put MPS where the branches part, before the first of them\n"
     "t:9:1: error: MPP without MPS: no branch is open in this network\n"
     "    put MPS where the branches part, before the first of them\n"},
    {"BlockAcrossABranch", "LD X1\nMPS\nLD X2\nMPP\nOUT Y0\nEND", std::nullopt,
     "t:4:1: error: MPP with 2 blocks open, but its MPS at line 2 had 1\n"
     "    join the blocks of the branch with ANB or ORB and use them in an output first\n"},
    {"BranchWithinABlock", "LD X0\nLD X1\nMPS\nANB\nMPP\nOUT Y0\nEND", std::nullopt,
     "t:5:1: error: MPP with 1 block open, but its MPS at line 3 had 2\n"
     "    join blocks either before MPS or after MPP\n"},
    {"ContactsWithoutOutput", "LD X0\nOUT Y0\nAND X1\nEND", std::nullopt,
     "t:3:1: error: the network ends here, but no output uses the result of this AND\n"
     "    add the output (OUT, SET, RST, MOV, ...) or remove these contacts\n"},
    {"BlocksTooDeep",
     "LD X0\nLD X0\nLD X0\nLD X0\nLD X0\nLD X0\nLD X0\nLD X0\nLD "
     "X0\nORB\nORB\nORB\nORB\nORB\nORB\nORB\nORB\nOUT Y0\nEND",
     std::nullopt,
     "t:9:1: error: LD opens block 9, but fx nests at most 8\n"
     "    join blocks earlier with ANB or ORB, or use a relay (M) for a part of the logic\n"},
    {"BlocksTooDeepInQ",
     "LD X0\nLD X0\nLD X0\nLD X0\nLD X0\nLD X0\nLD X0\nLD X0\nLD X0\nLD X0\nLD X0\nLD X0\nLD "
     "X0\nLD X0\nLD X0\nLD X0\nLD "
     "X0\nORB\nORB\nORB\nORB\nORB\nORB\nORB\nORB\nORB\nORB\nORB\nORB\nORB\nORB\nORB\nORB\nOUT "
     "Y0\nEND",
     Dialect::Q,
     "t:17:1: error: LD opens block 17, but q nests at most 16\n"
     "    join blocks earlier with ANB or ORB, or use a relay (M) for a part of the logic\n"},
    {"BranchesTooDeep",
     "LD X0\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nOUT Y0\nEND", std::nullopt,
     "t:13:1: error: MPS opens branch 12, but fx nests at most 11\n"
     "    use a relay (M) for a part of the logic\n"},
    {"BranchesTooDeepInQ",
     "LD "
     "X0\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nMPS\nOUT "
     "Y0\nEND",
     Dialect::Q,
     "t:18:1: error: MPS opens branch 17, but q nests at most 16\n"
     "    use a relay (M) for a part of the logic\n"},
    {"WithOtherErrors", "LD D1\nLDE= D0 D2\nOUT Y0\nLD X8\nANB\nOUT D0\nEND", std::nullopt,
     "t:1:4: error: LD D1: a word where a bit is read\n"
     "    name an X, Y or M\n"
     "t:2:1: error: LDE=: a compare contact on floating-point numbers, not supported yet\n"
     "t:3:1: error: OUT uses the block of LDE= at line 2, which nothing joins with the one of LD "
     "at "
     "line 1\n"
     "    join them with ANB (in series) or ORB (in parallel) before this output\n"
     "t:4:4: error: LD X8: not an input: its numbers are octal (digits 0 to 7) in dialect fx\n"
     "    after X7 comes X10; for a list with hexadecimal X and Y use --dialect q\n"
     "t:5:1: error: ANB joins two blocks, but only the one of LD at line 4 is open\n"
     "    each block begins with its own LD or LDI; after an output begin a branch with MPS\n"
     "t:6:5: error: OUT D0: a word where a bit is written\n"
     "    name a Y or M; a word is written by MOV\n"},
    {"SilentAfterAnUnknownWord", "LD X0\nFOO X1\nANB\nOUT Y0\nLD X2\nORB\nOUT Y1\nEND",
     std::nullopt,
     "t:2:1: error: FOO is not an instruction\n"
     "    did you mean FOR?\n"
     "t:6:1: error: ORB joins two blocks, but only the one of LD at line 5 is open\n"
     "    each block begins with its own LD or LDI; after an output begin a branch with MPS\n"},
};

constexpr Refused kFiles[] = {
    {"Empty", "", std::nullopt, "t:1:1: error: the file is empty\n"},
    {"OnlyAByteOrderMark", "\xEF\xBB\xBF", std::nullopt, "t:1:1: error: the file is empty\n"},
    {"OnlyComments", "; nothing\n", std::nullopt,
     "t:1:1: error: there is no instruction in this file\n"},
    {"NoEnd", "LD X0\nOUT Y0\n", std::nullopt,
     "t:2:7: error: the program has no END\n"
     "    put END after its last instruction; if it was cut off, copy it again\n"},
    {"NoEndBeforeAComment", "LD X0\n  OUT Y0  ; END\n\n", std::nullopt,
     "t:2:9: error: the program has no END\n"
     "    put END after its last instruction; if it was cut off, copy it again\n"},
    {"AfterEnd", "LD X0\nOUT Y0\nEND\nLD X1\nOUT Y1\nEND\n", std::nullopt,
     "t:4:1: error: LD stands after END, where nothing is executed\n"
     "    remove what follows END, or END itself\n"},
    {"OpenComment", "LD X0\nOUT Y0 (* bla\nEND\n", std::nullopt,
     "t:2:8: error: this comment is never closed\n"
     "    end it with *)\n"},
    {"NulByte", std::string_view("LD X0\n\x00OUT", 10), std::nullopt,
     "t:1:1: error: this is a binary file: it holds NUL bytes\n"
     "    if it is text, save it as UTF-8, or as UTF-16 with a byte order mark\n"},
    {"ControlCharacter", "LD X0\n\x01OUT", std::nullopt,
     "t:1:1: error: this is a binary file: it holds the control character 0x01\n"
     "    if it is text, save it as UTF-8, or as UTF-16 with a byte order mark\n"},
    {"Utf16CutOff",
     std::string_view("\xFF\xFEL\x00"
                      "D\x00 ",
                      7),
     std::nullopt,
     "t:1:3: error: the file ends within a UTF-16 character\n"
     "    it was cut off: copy or export it again\n"},
    {"Utf16HalfASurrogate",
     std::string_view("\xFF\xFEL\x00\n\x00=\xD8"
                      "D\x00",
                      10),
     std::nullopt,
     "t:2:1: error: half a surrogate pair: not valid UTF-16\n"
     "    save it as UTF-8, or as UTF-16 with a byte order mark\n"},
    {"NotUtf8", "LD X0\nOU\xFF", std::nullopt,
     "t:2:3: error: the byte 0xFF is valid neither in UTF-8 nor in Shift-JIS\n"
     "    save it as UTF-8, or as UTF-16 with a byte order mark\n"},
};

INSTANTIATE_TEST_SUITE_P(Structure, RefusedStructure, testing::ValuesIn(kStructure), refused_name);
INSTANTIATE_TEST_SUITE_P(Files, RefusedStructure, testing::ValuesIn(kFiles), refused_name);

}  // namespace
}  // namespace rung
