# SPDX-License-Identifier: Apache-2.0
"""A few known faults of MPU1, which show in `make test` that the machinery of `make mutate` works.

usage: sample.py draw FOLDER             write the netlist and what was drawn, for tb/mutate
       sample.py check FOLDER PROGRAM    run the tests of each mutant, and the proofs; exit code 1 if one is not as it
                                         has to be
"""
from __future__ import annotations

import dataclasses
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from flow import tools  # noqa: E402
from mutation import campaign, netlist, proof, subjects  # noqa: E402

SLOT = "core.g_slot[0].slot."
# Signal, bit, fault; whether a test notices it, whether it is proven to change nothing. The last but one would be
# noticed by a scan of a million clocks; the last is the sum's lowest bit, which takes the carry in and is dropped.
KNOWN = (
    ("done_o", 0, "inv", True, False),
    ("clocks_o", 5, "const0", True, False),
    (f"{SLOT}words.s1.x_value_q", 15, "const1", True, False),
    (f"{SLOT}words.s2.d2_forward", 7, "const0", True, False),
    (f"{SLOT}x_acc", 5, "const1", True, False),
    ("clocks_o", 20, "const0", False, False),
    (f"{SLOT}words.alu.x_chain", 0, "const1", False, True),
)


def subject(program: str) -> subjects.Subject:
    whole = subjects.processor(1, "hx8k", len(KNOWN))
    trial = dataclasses.replace(whole.trials[-1], program=program)
    return dataclasses.replace(whole, name="sample_mpu1", trials=(trial,))


def mutants(folder: Path) -> list[netlist.Mutant]:
    lines = (folder / "drawn.txt").read_text(encoding="utf-8").splitlines()
    return [netlist.parse(line, number) for number, line in enumerate(lines, 1)]


def draw(folder: Path) -> None:
    sample = subject("")
    tools.generate_isa_header()
    sample.folder.mkdir(parents=True, exist_ok=True)
    here = sample.folder.relative_to(tools.ROOT)
    script = sample.folder / "draw.ys"
    files = [sample.folder / f"drawn{place}.txt" for place in range(len(KNOWN))]
    tools.write_file(script, netlist.read_script(sample) + f"write_rtlil {here}/whole.il\n" + "".join(
        f"mutate -list 1 -wire {wire} -wirebit {bit} -mode {mode} -o {file.relative_to(tools.ROOT)} {sample.top}\n"
        for file, (wire, bit, mode, *_) in zip(files, KNOWN)))
    tools.run([tools.YOSYS, "-s", str(script)], tools.LOGS / "mutate-sample-draw.log")
    tools.write_file(folder / "drawn.txt", "".join(file.read_text(encoding="utf-8") for file in files))
    drawn = mutants(folder)
    if [(mutant.wire, mutant.wire_bit, mutant.mode) for mutant in drawn] != [entry[:3] for entry in KNOWN]:
        raise tools.FlowError("a signal of KNOWN is not in MPU1 any more")
    netlist.write(sample, drawn, folder)


def check(folder: Path, program: str) -> int:
    sample = subject(str(Path(program).resolve()))
    if seen := campaign.run(sample, 0, sample.trials[0], 600):
        print(f"without a fault the tests fail: {seen}")
        return 1
    drawn, wrong = mutants(folder), 0
    prover = proof.Prover(sample, drawn)
    for mutant, (*_, noticed, equal) in zip(drawn, KNOWN):
        seen = campaign.run(sample, mutant.number, sample.trials[0], 600)
        verdict = prover.attempt(mutant, 0)
        print(f"{mutant.place}: {mutant.describe()}: {seen or 'no test notices it'}; {verdict.why}")
        wrong += (bool(seen), verdict.equal) != (noticed, equal)
    return 1 if wrong else 0


if __name__ == "__main__":
    try:
        if sys.argv[1] == "draw":
            draw(Path(sys.argv[2]).resolve())
        else:
            sys.exit(check(Path(sys.argv[2]).resolve(), sys.argv[3]))
    except tools.FlowError as error:
        sys.exit(f"sample: {error}")
