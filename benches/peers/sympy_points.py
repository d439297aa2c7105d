"""Control points over [-1/3, 7/5] of the polynomial of degree 3 that the race uses, with SymPy.

Prints the nanoseconds a call (median of processor time), then the control points.
"""

from statistics import median
from time import thread_time_ns

from sympy import Poly, Rational, binomial
from sympy.abc import x

DEGREE = 3
ROUNDS = 15
CALLS = 50


def thousandths(count):
    """The same numbers as in src/data.rs."""
    state = 1
    for _ in range(count):
        state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
        yield Rational((state >> 33) % 2001 - 1000, 1000)


def points(polynomial, r, s):
    n = polynomial.degree()
    moved = polynomial.compose(Poly(r + (s - r) * x, x))
    row = [c / binomial(n, k) for k, c in enumerate(reversed(moved.all_coeffs()))]
    # Sums of neighbours, n times: row[j] becomes the sum of C(j, k) row[k].
    for k in range(n):
        for j in range(n, k, -1):
            row[j] += row[j - 1]
    return row


def main():
    polynomial = Poly(list(thousandths(DEGREE + 1))[::-1], x)
    ends = Rational(-1, 3), Rational(7, 5)
    nanoseconds = []
    for _ in range(ROUNDS):
        start = thread_time_ns()
        for _ in range(CALLS):
            answer = points(polynomial, *ends)
        nanoseconds.append((thread_time_ns() - start) / CALLS)
    print(round(median(nanoseconds)), *answer)


main()
