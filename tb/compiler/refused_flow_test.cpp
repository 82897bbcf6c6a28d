// SPDX-License-Identifier: Apache-2.0
// Refused lists: labels, jumps, subroutines, loops, zones and states that do not hold together.
#include <gtest/gtest.h>

#include "refused.hpp"

namespace rung {
namespace {

class RefusedFlow : public testing::TestWithParam<Refused> {};

TEST_P(RefusedFlow, SaysWhereWhatAndHowToMend) { expect_refused(GetParam()); }

constexpr Refused kFlow[] = {
    {"LabelMissing", "LD X0\nCJ P1\nCALL P2\nFEND\nEND", std::nullopt,
     "t:2:1: error: CJ P1: there is no label P1\n"
     "    put P1 before the instruction it leads to\n"
     "t:3:1: error: CALL P2: there is no label P2\n"
     "    put P2 before the instruction it leads to\n"},
    {"LabelTwice", "P1\nLD X0\nOUT Y0\nP1\nLD X0\nOUT Y1\nEND", std::nullopt,
     "t:4:1: error: P1: this label stands at line 1 already\n"
     "    give one of the two another number\n"},
    {"EndPointerAsLabel", "P63\nLD X0\nOUT Y0\nEND", std::nullopt,
     "t:1:1: error: P63: on an FX this pointer is END itself and labels nothing else\n"
     "    give the label another number\n"},
    {"BackwardJump", "LD X0\nOUT Y0\nP1\nLD X1\nOUT Y1\nLD X2\nCJ P1\nEND", std::nullopt,
     "t:7:1: error: CJ P1: a backward jump, to line 3: the scan would not be constant\n"
     "    use FOR with a constant count, or let the next scan go on\n"},
    {"JumpOutOfRoutine",
     "LD X0\nCJ P1\nCJ P2\nFEND\nP1\nLD X1\nOUT Y1\nCJ P2\nSRET\nP2\nLD X2\nOUT Y2\nSRET\nEND",
     std::nullopt,
     "t:2:1: error: CJ P1: leads out of its routine, over FEND or SRET\n"
     "    a subroutine is entered by CALL\n"
     "t:3:1: error: CJ P2: leads out of its routine, over FEND or SRET\n"
     "    a subroutine is entered by CALL\n"
     "t:8:1: error: CJ P2: leads out of its routine, over FEND or SRET\n"
     "    a subroutine is entered by CALL\n"},
    {"JumpIntoALoop", "LD X0\nCJ P1\nFOR K3\nLD X1\nCJ P2\nP1\nLD X0\nINC D0\nNEXT\nP2\nEND",
     std::nullopt,
     "t:2:1: error: CJ P1: leads into a loop, a zone of MC or the state of an STL\n"
     "    jump within it, or over the whole of it\n"
     "t:5:1: error: CJ P2: leads out of a loop, a zone of MC or the state of an STL\n"
     "    jump within it, or over the whole of it\n"},
    {"JumpIntoAZone",
     "LD X0\nCJ P1\nLD X1\nMC N0 M0\nLD X0\nCJ P2\nP1\nLD X1\nOUT Y0\nMCR N0\nP2\nEND",
     std::nullopt,
     "t:2:1: error: CJ P1: leads into a loop, a zone of MC or the state of an STL\n"
     "    jump within it, or over the whole of it\n"
     "t:6:1: error: CJ P2: leads out of a loop, a zone of MC or the state of an STL\n"
     "    jump within it, or over the whole of it\n"},
    {"JumpIntoAState",
     "LD X0\nCJ P1\nSTL S0\nLD X1\nCJ P2\nP1\nLD X1\nOUT Y0\nSTL S1\nP2\nLD X1\nSET S0\nRET\nEND",
     std::nullopt,
     "t:2:1: error: CJ P1: leads into a loop, a zone of MC or the state of an STL\n"
     "    jump within it, or over the whole of it\n"
     "t:5:1: error: CJ P2: leads into a loop, a zone of MC or the state of an STL\n"
     "    jump within it, or over the whole of it\n"},
    {"JumpToEndFromInside",
     "LD X0\nCALL P1\nFOR K2\nLD X0\nCJ P63\nNEXT\nFEND\nP1\nLD X0\nCJ P63\nSRET\nEND",
     std::nullopt,
     "t:5:1: error: CJ P63: END from within a subroutine, loop, zone or state is not supported\n"
     "    jump to a label at its end\n"
     "t:10:1: error: CJ P63: END from within a subroutine, loop, zone or state is not supported\n"
     "    jump to a label at its end\n"},
    {"LoopNotClosed", "FOR K3\nLD X0\nINC D0\nEND", std::nullopt,
     "t:1:1: error: FOR without NEXT: it is still open at the end of the program\n"
     "    put NEXT where it ends\n"},
    {"LoopNotClosedAtFend", "FOR K3\nLD X0\nINC D0\nFEND\nEND", std::nullopt,
     "t:1:1: error: FOR without NEXT: it is still open at FEND\n"
     "    put NEXT where it ends\n"},
    {"NextAlone", "LD X0\nINC D0\nNEXT\nEND", std::nullopt,
     "t:3:1: error: NEXT without FOR: none is open here\n"
     "    put FOR where it begins, or remove this\n"},
    {"LoopsTooDeep",
     "FOR K1\nFOR K1\nFOR K1\nFOR K1\nFOR K1\nFOR K1\nLD X0\nINC "
     "D0\nNEXT\nNEXT\nNEXT\nNEXT\nNEXT\nNEXT\nEND",
     std::nullopt,
     "t:6:1: error: FOR opens loop 6, but fx nests at most 5\n"
     "    put the inner loops into a subroutine\n"},
    {"LoopsTooDeepInQ",
     "FOR K1\nFOR K1\nFOR K1\nFOR K1\nFOR K1\nFOR K1\nFOR K1\nFOR K1\nFOR K1\nFOR K1\nFOR K1\nFOR "
     "K1\nFOR K1\nFOR K1\nFOR K1\nFOR K1\nFOR K1\nLD X0\nINC "
     "D0\nNEXT\nNEXT\nNEXT\nNEXT\nNEXT\nNEXT\nNEXT\nNEXT\nNEXT\nNEXT\nNEXT\nNEXT\nNEXT\nNEXT\nNEXT"
     "\nNEXT\nNEXT\nEND",
     Dialect::Q,
     "t:17:1: error: FOR opens loop 17, but q nests at most 16\n"
     "    put the inner loops into a subroutine\n"},
    {"ZoneNotClosed", "LD X0\nMC N0 M0\nLD X0\nOUT Y0\nEND", std::nullopt,
     "t:2:1: error: MC without MCR: it is still open at the end of the program\n"
     "    put MCR where it ends\n"},
    {"ZoneAlone", "LD X0\nOUT Y0\nMCR N0\nEND", std::nullopt,
     "t:3:1: error: MCR without MC: none is open here\n"
     "    put MC where it begins, or remove this\n"},
    {"ZoneOutOfOrder", "LD X0\nMC N1 M0\nLD X0\nOUT Y0\nMCR N1\nEND", std::nullopt,
     "t:2:1: error: MC N1: no zone is open here, so that this one is N0\n"
     "    write MC N0 and MCR N0\n"
     "t:5:1: error: MCR N1: no zone of this level is open here\n"
     "    write MCR N0\n"},
    {"ZoneOfTheSameLevel", "LD X0\nMC N0 M0\nLD X0\nMC N0 M1\nLD X0\nOUT Y0\nMCR N0\nEND",
     std::nullopt,
     "t:2:1: error: MC without MCR: it is still open at the end of the program\n"
     "    put MCR where it ends\n"
     "t:4:1: error: MC N0: the zones N0 to N0 are open here, so that this one is N1\n"
     "    close the zones from N0 on with MCR N0 first\n"},
    {"ZoneOfAnotherLevel", "LD X0\nMC N0 M0\nLD X0\nOUT Y0\nMCR N1\nEND", std::nullopt,
     "t:5:1: error: MCR N1: no zone of this level is open here\n"
     "    write MCR N0\n"},
    {"ZoneAcrossALoop", "LD X0\nMC N0 M0\nFOR K2\nLD X0\nINC D0\nMCR N0\nNEXT\nEND", std::nullopt,
     "t:6:1: error: MCR here, where the FOR of line 3 is still open\n"
     "    close what is inside first\n"
     "t:7:1: error: NEXT without FOR: none is open here\n"
     "    put FOR where it begins, or remove this\n"},
    {"LoopAcrossAZone", "FOR K2\nLD X0\nMC N0 M0\nLD X0\nINC D0\nNEXT\nMCR N0\nEND", std::nullopt,
     "t:6:1: error: NEXT here, where the MC of line 3 is still open\n"
     "    close what is inside first\n"
     "t:7:1: error: MCR without MC: none is open here\n"
     "    put MC where it begins, or remove this\n"},
    {"StateNotClosed", "STL S0\nOUT Y0\nSTL S1\nOUT Y1\nEND", std::nullopt,
     "t:3:1: error: STL without RET: it is still open at the end of the program\n"
     "    put RET where it ends\n"},
    {"RetAlone", "LD X0\nOUT Y0\nRET\nEND", std::nullopt,
     "t:3:1: error: RET without STL: none is open here\n"
     "    put STL where it begins, or remove this\n"},
    {"ZoneInAState", "STL S0\nLD X0\nMC N0 M0\nLD X0\nOUT Y0\nMCR N0\nRET\nEND", std::nullopt,
     "t:3:1: error: MC within the state of an STL, which an FX does not allow\n"
     "    put the zone's condition into each network of the state\n"},
    {"LoopInAState", "STL S0\nFOR K2\nLD X0\nOUT Y0\nNEXT\nRET\nEND", std::nullopt,
     "t:2:1: error: FOR within the state of an STL, which is not supported\n"
     "    put the loop outside of the state, or write its body as often as it runs\n"},
    {"StateInALoop", "FOR K2\nSTL S0\nOUT Y0\nRET\nNEXT\nEND", std::nullopt,
     "t:2:1: error: STL within a loop: a state has one place in the scan\n"
     "    put the state outside of FOR and NEXT\n"},
    {"StateInASubroutine", "LD X0\nCALL P0\nFEND\nP0\nSTL S0\nOUT Y0\nRET\nSRET\nEND", std::nullopt,
     "t:5:1: error: STL outside of the main program\n"
     "    put states before FEND\n"},
    {"ContactAfterStl", "STL S0\nAND X0\nOUT Y0\nRET\nEND", std::nullopt,
     "t:2:1: error: AND right after STL: only LD or an output may stand there\n"
     "    begin with LD or LDI\n"},
    {"SretInTheMainProgram", "LD X0\nOUT Y0\nSRET\nEND", std::nullopt,
     "t:3:1: error: SRET without a subroutine: this is the main program\n"
     "    end the main program with FEND and put the subroutine, with its label, behind it\n"},
    {"SubroutineBeforeFend", "LD X0\nCALL P1\nP1\nLD X1\nOUT Y1\nFEND\nEND", std::nullopt,
     "t:2:1: error: CALL P1: the label, at line 3, is in the main program\n"
     "    put the subroutine behind FEND\n"},
    {"NoFend", "LD X0\nCALL P1\nP1\nLD X1\nOUT Y1\nSRET\nEND", std::nullopt,
     "t:2:1: error: CALL P1: the label, at line 3, is in the main program\n"
     "    end the main program with FEND, before its first subroutine\n"
     "t:6:1: error: SRET without a subroutine: this is the main program\n"
     "    end the main program with FEND and put the subroutine, with its label, behind it\n"},
    {"NoSret", "LD X0\nCALL P1\nFEND\nP1\nLD X1\nOUT Y1\nEND", std::nullopt,
     "t:4:1: error: P1: this subroutine has no SRET\n"
     "    end it with SRET, before the next label that is called and before END\n"
     "t:2:1: note: P1 is called here\n"},
    {"NoSretBeforeFend", "LD X0\nCALL P1\nFEND\nP1\nLD X1\nOUT Y1\nFEND\nEND", std::nullopt,
     "t:4:1: error: P1: this subroutine has no SRET\n"
     "    end it with SRET, before the next label that is called and before END\n"
     "t:2:1: note: P1 is called here\n"},
    {"CallIntoALoop", "LD X0\nCALL P1\nFEND\nFOR K2\nP1\nLD X1\nINC D0\nNEXT\nSRET\nEND",
     std::nullopt,
     "t:2:1: error: CALL P1: leads into a loop or a zone of MC\n"
     "    put the label before it\n"},
    {"Recursion", "LD X0\nCALL P1\nFEND\nP1\nLD X1\nCALL P2\nSRET\nP2\nLD X2\nCALL P1\nSRET\nEND",
     std::nullopt,
     "t:10:1: error: CALL P1: recursion: P1 is being called already\n"
     "    a constant scan has no recursion: use FOR with a constant count\n"},
    {"CallsItself", "LD X0\nCALL P1\nFEND\nP1\nLD X1\nCALL P1\nSRET\nEND", std::nullopt,
     "t:6:1: error: CALL P1: recursion: P1 is being called already\n"
     "    a constant scan has no recursion: use FOR with a constant count\n"},
    {"CallsTooDeep",
     "LD X0\nCALL P1\nFEND\nP1\nLD X0\nCALL P2\nSRET\nP2\nLD X0\nCALL P3\nSRET\nP3\nLD X0\nCALL "
     "P4\nSRET\nP4\nLD X0\nCALL P5\nSRET\nP5\nLD X0\nCALL P6\nSRET\nP6\nLD X0\nOUT Y0\nSRET\nEND",
     std::nullopt,
     "t:22:1: error: CALL P6: with it, calls nest more than the 5 deep that fx allows\n"
     "    write a subroutine's instructions where it is called\n"},
    {"CallsTooDeepInQ",
     "LD X0\nCALL P1\nFEND\nP1\nLD X0\nCALL P2\nRET\nP2\nLD X0\nCALL P3\nRET\nP3\nLD X0\nCALL "
     "P4\nRET\nP4\nLD X0\nCALL P5\nRET\nP5\nLD X0\nCALL P6\nRET\nP6\nLD X0\nCALL P7\nRET\nP7\nLD "
     "X0\nCALL P8\nRET\nP8\nLD X0\nCALL P9\nRET\nP9\nLD X0\nCALL P10\nRET\nP10\nLD X0\nCALL "
     "P11\nRET\nP11\nLD X0\nCALL P12\nRET\nP12\nLD X0\nCALL P13\nRET\nP13\nLD X0\nCALL "
     "P14\nRET\nP14\nLD X0\nCALL P15\nRET\nP15\nLD X0\nCALL P16\nRET\nP16\nLD X0\nCALL "
     "P17\nRET\nP17\nLD X0\nOUT Y0\nRET\nEND",
     Dialect::Q,
     "t:66:1: error: CALL P17: with it, calls nest more than the 16 deep that q allows\n"
     "    write a subroutine's instructions where it is called\n"},
    {"TooLargeByLoops", "FOR K300\nFOR K300\nLD X0\nINC D0\nNEXT\nNEXT\nEND", std::nullopt,
     "t:1:1: error: with loops and subroutines written out, which is how a constant scan runs "
     "them, the program has more than 65536 instructions here\n"
     "    let loops run less often\n"},
    {"TooLargeByCalls",
     "FOR K1000\nLD X0\nCALL P1\nNEXT\nFEND\nP1\nFOR K100\nLD X0\nINC D0\nNEXT\nSRET\nEND",
     std::nullopt,
     "t:1:1: error: with loops and subroutines written out, which is how a constant scan runs "
     "them, the program has more than 65536 instructions here\n"
     "    let loops run less often\n"},
    {"BetweenWithoutOutput",
     "LD X0\nP1\nLD X0\nMPS\nAND X1\nOUT Y0\nMCR N0\nLD X0\nFEND\nOUT Y0\nEND", std::nullopt,
     "t:1:1: error: the network ends here, but no output uses the result of this LD\n"
     "    add the output (OUT, SET, RST, MOV, ...) or remove these contacts\n"
     "t:4:1: error: MPS without MPP: the branch is still open at the end of the network\n"
     "    read the last branch with MPP instead of MRD\n"
     "t:7:1: error: MCR without MC: none is open here\n"
     "    put MC where it begins, or remove this\n"
     "t:8:1: error: the network ends here, but no output uses the result of this LD\n"
     "    add the output (OUT, SET, RST, MOV, ...) or remove these contacts\n"
     "t:10:1: error: OUT has no result to work on: no LD or LDI before it\n"
     "    begin the network with LD or LDI\n"},
};

INSTANTIATE_TEST_SUITE_P(Flow, RefusedFlow, testing::ValuesIn(kFlow), refused_name);

}  // namespace
}  // namespace rung
