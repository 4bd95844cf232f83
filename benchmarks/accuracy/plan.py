"""Which runs make up the matrix: for each case its resolutions, and the settings that are varied.

A case runs with its default settings at every resolution. Level quick varies one setting at a time at the case's `at` resolution; level
full takes all combinations of two settings at every resolution. A choice that does not apply to a case is not in its list.
"""
from itertools import combinations

KERNELS = {"kernel": ["mcg03", "cubic"]}
SUPPORTS = {"support": ["1.5", "2.5", "3"]}
PRECISION = {"precision": ["double"]}
FLUID = {**KERNELS, **SUPPORTS, **PRECISION, "pressure": ["printed"]}

# name: (resolutions from coarse to fine, the one at which settings are varied, settings)
CASES = {
    "slabs": (["0.05", "0.025", "0.0125"], "0.0125", {**KERNELS, **SUPPORTS, **PRECISION, "conduction": ["plain"], "cfl_heat": ["0.4", "0.2"]}),
    "conductivity_ratio": (["0.025", "0.0125", "0.00625"], "0.0125", {**KERNELS, **SUPPORTS, **PRECISION, "conduction": ["plain"], "cfl_heat": ["0.4", "0.2"]}),
    "sphere_bath": (["0.125", "0.0625"], "0.0625", {**KERNELS, **SUPPORTS, "conduction": ["plain"]}),
    "sphere_biot": (["0.125", "0.0625"], "0.0625", {**KERNELS, **SUPPORTS, "conduction": ["plain"]}),
    "stefan_one_phase": (["0.04", "0.02", "0.01", "0.005"], "0.01", {**KERNELS, **SUPPORTS, "conduction": ["plain"], "cfl_heat": ["0.4"]}),
    "stefan_two_phase": (["0.04", "0.02", "0.01", "0.005"], "0.01", {**KERNELS, **SUPPORTS, "conduction": ["plain"], "cfl_heat": ["0.4"]}),
}


def runs(level):
    """(case, spacing, [numerics key=value, ...]) in the order in which they are run: defaults first, cheap resolutions first."""
    todo = []
    deepest = max(len(spacings) for spacings, _, _ in CASES.values())
    for k in range(deepest):
        todo += [(case, spacings[k], []) for case, (spacings, _, _) in CASES.items() if k < len(spacings)]
    for case, (spacings, at, axes) in CASES.items():
        choices = [f"numerics.{key}={value}" if "." not in key else f"{key}={value}" for key, values in axes.items() for value in values]
        if level == "quick":
            todo += [(case, at, [c]) for c in choices]
        else:
            pairs = [list(p) for p in combinations(choices, 2) if p[0].split("=")[0] != p[1].split("=")[0]]
            todo += [(case, s, c) for s in spacings for c in [[c] for c in choices] + pairs]
    return todo
