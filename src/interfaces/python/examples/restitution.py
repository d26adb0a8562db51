"""e(v) of a steel ball on three half-spaces, as a picture: run it as it is, or cell by cell in a notebook."""

# %%
import sys

import matplotlib

matplotlib.use("agg")  # without a window; leave this line out in a notebook
import matplotlib.pyplot as plt
import numpy as np
import plm_impact as plm

# %% the bodies: texts with a unit, or numbers in SI
steel = {"youngs_modulus": "210 GPa", "poissons_ratio": 0.3}
contact = plm.Contact(
    sphere={"radius": "5 mm", "density": "7850 kg/m^3", **steel},
    half_space={"yield_strength": "345 MPa", **steel},
)
print(contact)

# %% one impact: its results by name, its trace as a structured array
impact = contact.impact("0.5 m/s")
print(impact, impact.trace["force_N"].max(), sep="\n")

# %% a table: every key takes an array, and arrays are broadcast
speeds = np.logspace(-3, 0.3, 400)
strengths = np.array([200e6, 345e6, 900e6])
table = plm.impacts(contact, speed=speeds, yield_strength=strengths[:, np.newaxis])

# %% a picture
figure, axes = plt.subplots()
for strength, restitutions in zip(strengths, table["restitution"]):
    axes.loglog(speeds, restitutions, label=f"{strength / 1e6:.0f} MPa")
axes.set_xlabel("impact speed (m/s)")
axes.set_ylabel("coefficient of restitution")
axes.legend(title="yield strength")
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "restitution.png")
