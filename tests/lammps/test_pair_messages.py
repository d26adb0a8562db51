"""What pair_style plm refuses and what it warns of."""

from __future__ import annotations

from pathlib import Path

import pytest
from runs import INPUTS, ROOT, STEEL, changed, lammps
from spheres import DENSITY, write_pairs


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (("units si", "units lj"), "use si, cgs, micro or nano"),
        (("pair_style plm", "pair_style plm friction"), "unknown or incomplete keyword friction"),
        (("pair_style plm", "pair_style plm friction -1"), "must be a number of 0 or more"),
        (("pair_style plm", "pair_style plm rolling 0 0.1"), "stiffness 0 of rolling must be a positive number"),
        (("pair_style plm", "pair_style plm sticky 1"), "keyword sticky"),
        (("* * SCENARIO", "* *"), "expected: pair_coeff I J FILE"),
        (("* * SCENARIO", "1 1 SCENARIO"), "1      2: is not set"),
        (("* * SCENARIO", "1 * SCENARIO"), "types 1 and * overlap"),
        (("SCENARIO", "no-such-file.toml"), "no-such-file.toml: cannot be read"),
        (("SCENARIO", f"{ROOT}/scenarios/alumina-on-aluminium-with-waves.toml"), "different elastic constants"),
        (("SCENARIO", f"{ROOT}/scenarios/restitution-vs-speed.toml"), "sweep: is not supported in a DEM contact"),
        (("comm_modify vel yes\n", ""), "comm_modify vel yes"),
        (("atom_style sphere", "atom_style sphere\nfix early all plm/energy"), "unknown"),
    ],
)
def test_impossible_pair_is_refused(plugin: Path, tmp_path: Path, change: tuple, words: str) -> None:
    write_pairs(tmp_path / "pairs.data", [(5e-3, 3e-3)], [1.0], [(DENSITY, DENSITY)], (1, 2))
    style = "plm friction 0.3" if "vel" in change[0] else "plm"
    script = (INPUTS / "pair_meet.in").read_text().replace("pair_style ${style}", f"pair_style {style}")
    script = script.replace("${coeff}", "* * SCENARIO")
    if "early" in change[1]:
        change = ("pair_style plm\npair_coeff * * SCENARIO", "pair_style none\nfix early all plm/energy")
        words = "counts the energy of pair_style plm, which is not there"
    assert change[0] in script
    made = tmp_path / "bad.in"
    made.write_text(script.replace(*change).replace("SCENARIO", str(STEEL)))
    output = lammps(
        plugin, str(made), fails=True, data=tmp_path / "pairs.data", newton="on", dt="1e-7", n=1, out=tmp_path / "out"
    )
    assert words in output, output[-2000:]


NOT_SAID = ("when they first touch", "exceeds the validated", "not meaningful", "too long for e", "of one material")


@pytest.mark.parametrize(
    ("speed", "gap", "dt", "coeff", "words"),
    [
        (1.0, 0.0, "1e-7", "* * {steel}", []),
        (100.0, 0.0, "1e-8", "* * {steel}", ["exceeds the validated"]),
        (1.0, 2e-5, "1e-7", "* * {steel}", ["overlap by 2e-05 when they first touch, and move by 1e-07 in a step"]),
        (1.0, 0.0, "5e-6", "* * {steel}", ["e is not meaningful: the shortest contact has only"]),
        (
            1.0,
            0.0,
            "1e-7",
            "1 1 {steel}\npair_coeff 2 2 {steel}\npair_coeff 1 2 {steel}",
            ["types 1 and 2 are of one material"],
        ),
    ],
)
def test_doubtful_pair_warns_once(
    plugin: Path, tmp_path: Path, speed: float, gap: float, dt: str, coeff: str, words: list
) -> None:
    write_pairs(tmp_path / "pairs.data", [(5e-3, 3e-3)], [speed], [(DENSITY, DENSITY)], (1, 2))
    if gap:
        text = (tmp_path / "pairs.data").read_text()
        (tmp_path / "pairs.data").write_text(text.replace(repr(0.03 + 5e-3 + 1e-8), repr(0.03 + 5e-3 - gap)))
    script = (INPUTS / "pair_meet.in").read_text().replace("${coeff}", coeff.format(steel=STEEL))
    made = tmp_path / "doubtful.in"
    made.write_text(script.replace("run ${n}", "run ${n}\nrun ${n}"))
    output = lammps(
        plugin, str(made), data=tmp_path / "pairs.data", newton="on", style="plm", dt=dt, n=300, out=tmp_path / "out"
    )
    assert "steps of it keep e within 0.1 %" in output
    for word in words:
        assert output.count(word) == 1, output[-3000:]
    for word in NOT_SAID:
        assert word in " ".join(words) or word not in output, output[-3000:]


def test_second_command_replaces_the_first_one(plugin: Path, tmp_path: Path) -> None:
    """Friction cannot begin after a run, as the contacts have no place for it, and ends with a command that has none."""
    write_pairs(tmp_path / "pairs.data", [(5e-3, 3e-3)], [1.0], [(DENSITY, DENSITY)], angle=0.5)
    run = dict(data=tmp_path / "pairs.data", coeff=f"* * {STEEL}", newton="on", dt="1e-7", n=300, out=tmp_path / "out")
    second = changed(tmp_path, "pair_meet.in", ("run ${n}", "run 0\npair_style ${second}\nrun ${n}"))
    output = lammps(plugin, second, fails=True, style="plm", second="plm friction 0.3", **run)
    assert "friction or rolling cannot begin or end between runs" in output and "Give pair_style none first" in output
    before = changed(tmp_path, "pair_meet.in", ("pair_coeff ${coeff}", "pair_style ${second}\npair_coeff ${coeff}"))
    spins = []
    for first, last in (
        ("plm friction 0.3", "plm"),
        ("plm", "plm friction 0.3"),
        ("plm friction 0.1", "plm friction 0.3"),
    ):
        lammps(plugin, before, style=first, second=last, **run)
        spins.append(abs(float((tmp_path / "out").read_text().splitlines()[-1].split()[5])))
    assert spins[0] == 0.0 and spins[1] == spins[2] > 1.0
    # the way out of the message
    none = f"run 0\npair_style none\npair_style ${{second}}\npair_coeff * * {STEEL}\nrun ${{n}}"
    lammps(plugin, changed(tmp_path, "pair_meet.in", ("run ${n}", none)), style="plm", second="plm friction 0.3", **run)
    assert abs(float((tmp_path / "out").read_text().splitlines()[-1].split()[5])) == spins[1]
