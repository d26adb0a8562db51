"""Restitution and contact time (units of L/V) of the hard cases in `tests/core/impact/stability_cases.rs`, with 50 digits (mpmath):
energy balance for the peak and e, quadrature for the time. The law is written down anew here, from its definition
(`src/contact/law/plm/mod.rs`), so that nothing but the coefficients is shared with what it checks. Prints: name, e, T."""

import tomllib
from pathlib import Path

from mpmath import asin, atan, ceil, findroot, inf, log, mp, mpf, pi, quad, sqrt

mp.dps = 50
FIFTHS = mpf(2) / 5
TABLE = tomllib.loads(
    (Path(__file__).parents[2] / "src/contact/law/plm/coefficients.toml").read_text(), parse_float=mpf
)
FORCE, LINE, POISSON, DEPTH = (TABLE[name] for name in ("force", "elastic_approach", "poisson", "depth"))


def loading(starts, slopes):
    """Pieces (x, f, w, slope), the first with Hertz (slope None)."""
    pieces = [(mpf(0), mpf(0), mpf(0), None)]
    for start, slope in zip(starts, slopes):
        x, f, w, s = pieces[-1]
        d = start - x
        force, work = (d**1.5, FIFTHS * d**2.5) if s is None else (f + s * d, w + f * d + s * d * d / 2)
        pieces.append((start, force, work, slope))
    return pieces


def force_at(pieces, x):
    start, f, _, s = [piece for piece in pieces if piece[0] <= x][-1]
    return (x - start) ** 1.5 if s is None else f + s * (x - start)


def plm(kappa, a_over_r, c=mpf(1)):
    """The law of a half-space that yields alone, with c = C(0.3)/C(nu)."""
    t = [log(x / FORCE["from"][0]) / log(FORCE["from"][-1] / FORCE["from"][0]) for x in FORCE["from"]]
    slopes = [
        (s + k * kappa**2) * c ** min(1, POISSON["force"] * (1 + kappa**2) * t**2)
        for s, k, t in zip(FORCE["slope"], FORCE["slope_kappa_squared"], t)
    ]
    shallow, line = loading(FORCE["from"], slopes), elastic_line(kappa, a_over_r, c ** POISSON["approach"])
    from_x, to_x = DEPTH["from"] / a_over_r**2, DEPTH["to"] / a_over_r**2
    if to_x <= FORCE["from"][0]:
        return shallow, line
    plastic_from = 1 + LINE["plastic_from_rho"] * (1 - kappa)

    def y(x):
        if x <= from_x:
            return mpf(0)
        x = min(x, to_x)
        f = force_at(shallow, x)
        return (x * a_over_r**2 - DEPTH["from"]) * max(0, 1 - plastic_from * line(x, f) / f)

    def approach(x, f):
        if x <= from_x:
            return line(x, f)
        eps = line(x, force_at(shallow, x))
        return min(x, eps * (1 + DEPTH["recovery"] * (DEPTH["recovery_kappa"] - kappa) * y(x)))

    first = max(from_x, FORCE["from"][0])
    knots = [first, *(x for x, *_ in shallow if first < x < to_x), to_x]
    points = []
    for start, end in zip(knots, knots[1:]):
        count = int(ceil(log(end / start) / log(mpf("1.1"))))
        points += [start * (end / start) ** (mpf(i) / count) for i in range(1, count)] + [end]
    points += [x for x, *_ in shallow if x > to_x]
    pieces = [piece for piece in shallow if piece[0] < first]
    x, f, w = first, force_at(shallow, first), work_at(shallow, first)
    for end in points:
        force = force_at(shallow, end) / (1 + DEPTH["force"] * y(end))
        pieces.append((x, f, w, (force - f) / (end - x)))
        x, f, w = end, force, w + (end - x) * (f + force) / 2
    return [*pieces, (x, f, w, shallow[-1][3] / (1 + DEPTH["force"] * y(to_x)))], approach


def elastic_line(kappa, a_over_r, plastic_factor):
    plastic_from = 1 + LINE["plastic_from_rho"] * (1 - kappa)
    geometry = [(max(1, a / a_over_r), k) for a, k in zip(LINE["geometry_from"], LINE["geometry_factor"])]
    first = LINE["first_slope"] + LINE["first_slope_kappa_squared"] * kappa**2
    plastic = (LINE["plastic_slope"] + LINE["plastic_slope_kappa_squared"] * kappa**2) * plastic_factor

    def slope(a):
        s = plastic if a >= plastic_from else min(first, LINE["first_slope_limit"])
        for start, factor in geometry:
            s *= factor if a >= start else 1
        return s

    knots = sorted({mpf(1), plastic_from, *(g for g, _ in geometry)})

    def approach(x, f):
        if x <= 1:
            return x
        eps = mpf(1)
        for i, knot in enumerate(knots):
            s = slope(knot)
            end = knots[i + 1] if i + 1 < len(knots) else inf
            # eps = eps_i + s (A - A_i) with A = f/eps
            b = eps - s * knot
            found = (b + sqrt(b * b + 4 * s * f)) / 2
            if f / found <= end:
                return min(x, found)
            eps += s * (end - knot)
        raise AssertionError

    return approach


def stiffness(k):
    return lambda x, f: x if x <= 1 else min(x, (f / k) ** (mpf(2) / 3))


def work_at(pieces, x):
    start, f, w, s = [piece for piece in pieces if piece[0] <= x][-1]
    d = x - start
    return FIFTHS * d**2.5 if s is None else w + f * d + s * d * d / 2


def solve(law, q):
    pieces, approach = law
    kinetic = mpf(2) / 5 * q * q
    time = mpf(0)
    for i, (start, f, w, s) in enumerate(pieces):
        after = pieces[i + 1] if i + 1 < len(pieces) else None
        turns = after is None or after[2] >= kinetic
        entry = sqrt(2.5 * (kinetic - w))
        exit = mpf(0) if turns else sqrt(2.5 * (kinetic - after[2]))
        if s is None:
            # (x/q^0.8)^2.5 = sin^2 phi: t = (4/5) q^-0.2 int sin^-0.2 phi dphi, made smooth by phi = p^(5/4)
            x_m = q ** mpf("0.8")
            top = pi / 2 if turns else asin(sqrt((after[0] / x_m) ** 2.5))
            g = lambda p: (mp.sin(p**1.25) / p**1.25) ** mpf("-0.2") if p else mpf(1)
            time += mpf("0.8") * x_m / q * 1.25 * quad(g, [0, top ** mpf("0.8")])
            x, force = x_m, x_m**1.5
        else:
            omega = sqrt(1.25 * s)
            # u = U cos(phase): phases of entry and exit
            time += (
                atan(1.25 * (f + s * ((after[0] - start) if not turns else 0)) / (omega * exit))
                if not turns
                else pi / 2
            ) / omega
            time -= atan(1.25 * f / (omega * entry)) / omega if entry else pi / 2 / omega
            rest = kinetic - w
            x = start + 2 * rest / (f + sqrt(f * f + 2 * s * rest))
            force = f + s * (x - start)
        if turns:
            break
    eps = approach(x, force)
    e = sqrt(force * eps / 2.5 / kinetic) if x > 1 else mpf(1)
    hertz = (
        mpf("0.8")
        * 1.25
        * quad(lambda p: (mp.sin(p**1.25) / p**1.25) ** mpf("-0.2") if p else mpf(1), [0, (pi / 2) ** mpf("0.8")])
    )
    return e, time + hertz * eps / (e * q)


def largest_stress(nu):
    """The largest von Mises stress under a Hertz pressure over the largest pressure: on the axis, or at the rim of the contact
    (Johnson 1985, ch. 3.4)."""
    growth = lambda z: (1 + nu) * (atan(1 / z) - z / (1 + z * z)) - 3 * z / (1 + z * z) ** 2
    z = findroot(growth, (mpf("1e-9"), mpf(2)), solver="bisect", tol=mpf(10) ** -100, maxsteps=400, verify=False)
    axis = mpf("1.5") / (1 + z * z) - (1 + nu) * (1 - z * atan(1 / z))
    return max(axis, (1 - 2 * nu) / sqrt(mpf(3)))


def yield_factor(nu):
    if nu < 0:
        return mpf("1.30075") * largest_stress(mpf(0)) / largest_stress(nu)
    return mpf("1.30075") + mpf("0.87825") * nu + mpf("0.54373") * nu**2


def scene(kappa=mpf(1) / 2, nu=mpf("0.3"), strength=mpf("3e-3")):
    c = yield_factor(mpf("0.3")) / yield_factor(max(nu, mpf(0)))
    return plm(kappa, pi * yield_factor(nu) * strength / 2, c)


def speed_to(law, x):
    return sqrt(2.5 * work_at(law[0], x))


def many_knots(count, ratio):
    starts = [mpf("1.7") * ratio**i for i in range(count)]
    return loading(starts, [2 * (x / mpf("1.7")) ** mpf("0.2") for x in starts]), STEEL[1]


def steel_speed_ratio(v):
    e_star = mpf("210e9") / (2 * (1 - mpf("0.09")))
    a = pi * mpf("1.6") * mpf("345e6") / (2 * e_star)
    return v / (sqrt(mpf("0.8") * e_star / (pi * 7850)) * a**2.5)


STEEL = scene()
KINKED = loading([mpf(1)], [mpf("1.5")])
STIFF = (KINKED, stiffness(mpf("1e12")))
DENT = (KINKED, stiffness(mpf(1)))
HERTZ = ([(mpf(0), mpf(0), mpf(0), None)], lambda x, f: x)
CLOSE = many_knots(5, 1 + mpf("1e-12"))
CASES = [
    *(
        (f"v = v_Y (1 {o[0]} {o[1:]})", STEEL, mpf(1.0 + float(o)))
        for o in ["-1e-3", "-1e-6", "-1e-9", "-1e-12", "-1e-15"]
    ),
    ("v = v_Y", STEEL, mpf(1)),
    *((f"v = v_Y (1 + {o})", STEEL, mpf(1.0 + float(o))) for o in ["1e-15", "1e-12", "1e-9", "1e-6", "1e-3"]),
    *((f"peak on the knot at x = {x}", STEEL, speed_to(STEEL, mpf(x))) for x in ("1.7", "8.4", "225")),
    ("peak 1e-12 before the knot at x = 8.4", STEEL, speed_to(STEEL, mpf("8.4") * (1 - mpf("1e-12")))),
    ("peak 1e-12 behind the knot at x = 8.4", STEEL, speed_to(STEEL, mpf("8.4") * (1 + mpf("1e-12")))),
    ("v = 1e-100 v_Y", STEEL, mpf("1e-100")),
    ("elastic impact of any speed", HERTZ, mpf(1)),
    ("v = 1e4 v_Y", STEEL, mpf(10) ** 4),
    ("v = 1e8 v_Y", STEEL, mpf(10) ** 8),
    ("hardly any rebound: unloading 1e12 times as stiff", STIFF, mpf(100)),
    ("hardly any dent: x_r = 2.5e-13", DENT, speed_to(DENT, 1 + mpf("1e-6"))),
    ("200 knots", many_knots(200, mpf("1.02")), mpf(300)),
    ("five knots 1e-12 apart", CLOSE, mpf(30)),
    ("five knots 1e-12 apart, peak among them", CLOSE, speed_to(CLOSE, mpf("1.7") * (1 + 2 * mpf("1e-12")))),
    ("rigid sphere, E_s = inf", scene(mpf(0)), mpf(300)),
    ("rigid sphere, E_s = 1e30 Pa", scene(1 / (1 + mpf("1e30") / mpf("210e9"))), mpf(300)),
    ("E_s/E_h = 1e12", scene(1 / (1 + mpf("1e12"))), mpf(300)),
    ("E_s/E_h = 1e-3", scene(1 / (1 + mpf("1e-3"))), mpf(300)),
    ("E_s/E_h = 1e-12", scene(1 / (1 + mpf("1e-12"))), mpf(300)),
    ("R = 1e-9 m", STEEL, mpf(300)),
    ("R = 1e3 m", STEEL, mpf(300)),
    ("yield strength 1e-9 E*: plastic throughout", scene(strength=mpf("1e-9")), mpf(10) ** 6),
    ("yield strength 10 E*: elastic", HERTZ, mpf(1)),
    ("Poisson's ratios -0.99", scene(nu=mpf("-0.99")), mpf(300)),
    ("Poisson's ratios 0.4999999", scene(nu=mpf("0.4999999")), mpf(300)),
    ("P4a: 1 um at 10 m/s", (KINKED, stiffness(sqrt(mpf(2)))), steel_speed_ratio(10)),
    ("P4b: 1 m at 1e-6 m/s", (KINKED, stiffness(sqrt(mpf(2)))), steel_speed_ratio(mpf("1e-6"))),
    ("P4c: 1 nm at 100 m/s, Hertz alone", HERTZ, steel_speed_ratio(100)),
]
if __name__ == "__main__":
    for name, law, q in CASES:
        e, t = solve(law, q)
        print(f"{name}\t{mp.nstr(e, 17)}\t{mp.nstr(t, 17)}")
