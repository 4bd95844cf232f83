# SPDX-License-Identifier: Apache-2.0
"""Runs of the matrix: for each case its resolutions and the settings to vary.

A case runs with its default settings at every resolution. Level quick varies one setting at a time at the
case's `at` resolution; level full takes all combinations of two settings at every resolution. Settings that
do not apply to a case are not in its list.
"""
from itertools import combinations

KERNELS = {"kernel": ["mcg03", "cubic"]}
SUPPORTS = {"support": ["1.5", "2.5", "3"]}
WIDE = {"support": ["2.5", "3"]}
PRECISION = {"precision": ["double"]}
PRESSURE = {
    "density": ["plain", "summation"],
    "pressure": ["printed"],
    "pressure_solver": ["incompressible"],
    "cfl_sound": ["0.2", "0.8"],
}
SOLID = {"bond_support": ["1.5", "2"], "elastic_precision": ["single"], "cfl_elastic": ["0.2", "0.6"]}
HEAT = {**KERNELS, **SUPPORTS, "conduction": ["plain"]}

CARRIED = {"corrected_gradients": ["false"], "shifting": ["0"]}  # settings of the carried density
LIQUIDS = {"density": ["summation"], "shifting": ["0"], "pressure_solver": ["incompressible"]}
QUALITY = {"quality": ["preview", "reference"]}
SURFACE = {
    "surface.smoothing": ["plane"],
    "surface.support": ["4", "6"],
    "surface.particle_support": ["1", "1.5"],
    "surface.iso_level": ["0.4", "0.6"],
    "surface.enforce_volume": ["1"],
}
# h_ss at a quarter of a particle spacing; 8 is the paper's h_ss = h there
FINE_SURFELS = {"surface.spacing=0.015625 surface.support": ["3", "4", "6", "8"]}


def hourglass(*values):
    return {"material.rubber.hourglass": list(values)}


# name: (resolutions from coarse to fine, the resolution at which settings vary, settings)
CASES = {
    "hydrostatic": (
        ["0.05", "0.025"],
        "0.05",
        {**KERNELS, **WIDE, **PRECISION, **PRESSURE, **CARRIED, **QUALITY},
    ),
    "hydrostatic_jittered": (
        ["0.05", "0.025"],
        "0.05",
        {
            "density": ["summation"],
            **CARRIED,
            "pressure_solver": ["incompressible"],
            "support": ["3"],
            **QUALITY,
        },
    ),
    "ritter": (
        ["0.1", "0.05"],
        "0.05",
        {
            "kernel": ["cubic"],
            "density": ["plain", "summation"],
            **CARRIED,
            "pressure_solver": ["incompressible"],
            **PRECISION,
            **QUALITY,
        },
    ),
    "standing_wave": (
        ["0.025", "0.0125"],
        "0.025",
        {"density": ["summation"], "corrected_gradients": ["false"], "pressure_solver": ["incompressible"]},
    ),
    "martin_moyce": (
        ["0.005715", "0.0028575"],
        "0.0028575",
        {**KERNELS, **WIDE, **PRESSURE, **CARRIED, **PRECISION, **QUALITY},
    ),
    "elliptic_drop": (["0.1", "0.05", "0.025"], "0.05", {**LIQUIDS, **QUALITY}),
    "rotating_patch": (["0.05", "0.025", "0.0125"], "0.025", {**LIQUIDS, **QUALITY}),
    "floating_cube_50": (["0.0136", "0.0125", "0.0117"], "0.0125", {**LIQUIDS, **QUALITY}),
    "floating_cube_90": (["0.0136", "0.0125", "0.0112"], "0.0125", {**LIQUIDS}),
    "sinking_cube": (["0.0136", "0.0125", "0.0115"], "0.0125", {**LIQUIDS}),
    "rising_ball": (["0.0031", "0.0025", "0.0022", "0.00125"], "0.0025", {**LIQUIDS, **QUALITY}),
    "tanks": (["0.006666666666666667"], "0.006666666666666667", {}),
    "tanks_4": (["0.006666666666666667"], "0.006666666666666667", {}),
    "taylor_green": (["0.01"], "0.01", {}),
    "taylor_green_50": (
        ["0.02"],
        "0.02",
        {
            "pressure_solver": ["incompressible"],
            **KERNELS,
            **PRECISION,
            "density": ["summation"],
            "shifting": ["0", "0.1"],
            "corrected_gradients": ["false"],
            "tensile_limit": ["0"],
            "cfl_sound": ["0.2"],
        },
    ),
    "poiseuille": (
        ["0.1", "0.05", "0.025"],
        "0.05",
        {
            **KERNELS,
            **WIDE,
            **PRECISION,
            "density": ["summation"],
            **CARRIED,
            "viscosity": ["laplacian"],
            "viscosity_solver": ["implicit"],
            "pressure_solver": ["incompressible"],
            "cfl_viscous": ["0.4"],
            **QUALITY,
        },
    ),
    "poiseuille_startup": (
        ["0.1", "0.05"],
        "0.05",
        {**WIDE, "viscosity": ["laplacian"], "viscosity_solver": ["implicit"], "cfl_viscous": ["0.4"]},
    ),
    "thick_channel": (
        ["0.05"],
        "0.05",
        {"viscosity_solver": ["implicit"], "cfl_viscous": ["0.4"], "viscosity_correction": ["false"]},
    ),
    "bingham": (
        ["0.1", "0.05", "0.025"],
        "0.05",
        {
            "pressure_solver": ["incompressible"],
            "viscosity_correction": ["false"],
            "support": ["3"],
            **PRECISION,
            "material.mud.flow.yield_stress": ["0.4"],
            "material.mud.flow.least_rate": ["0.01"],
        },
    ),
    "herschel_bulkley": (
        ["0.1", "0.05", "0.025"],
        "0.05",
        {
            "viscosity_correction": ["false"],
            "material.mud.flow.yield_stress": ["0.4"],
            "material.mud.flow.least_rate": ["0.01"],
        },
    ),
    "herschel_bulkley_thick": (["0.1", "0.05", "0.025"], "0.05", {"viscosity_correction": ["false"]}),
    "yield_slump": (
        ["0.01", "0.00625"],
        "0.00625",
        {
            "material.paste.flow.yield_stress": ["221", "294"],
            "material.paste.flow.least_rate": ["0.01", "1e-4"],
        },
    ),
    "stiff_in_soft": (
        ["0.02"],
        "0.02",
        {"elastic_substeps": ["2", "4", "8", "16"], "pressure_solver": ["incompressible"]},
    ),
    "spinning_drop": (
        ["0.25", "0.125"],
        "0.125",
        {**PRECISION, "viscosity": ["laplacian"], "viscosity_solver": ["implicit"], "support": ["3"]},
    ),
    "drop_laplace": (
        ["0.2", "0.125", "0.0833333333333333", "0.0625"],
        "0.125",
        {
            "tension": ["pairwise", "surface energy"],
            "body.0.packing": ["lattice"],
            "support": ["2.5", "3"],
            **PRECISION,
        },
    ),
    "drop_oscillation": (
        ["0.125", "0.0833333333333333"],
        "0.125",
        {"tension": ["pairwise", "surface energy"], "support": ["2.5", "3"], **PRECISION},
    ),
    **{
        f"contact_angle_{angle}": (
            ["0.125", "0.0833333333333333"],
            "0.0833333333333333",
            {"tension": ["surface energy"]},
        )
        for angle in (30, 60, 90, 120, 150)
    },
    "birikh": (["0.1", "0.05"], "0.05", {"tension": ["surface energy"]}),
    "patch": (["0.1"], "0.1", {"elastic_precision": ["single"], "bond_support": ["1.5", "2"]}),
    "rotation": (["0.1"], "0.1", {"elastic_precision": ["single"], "bond_support": ["1.5", "2"]}),
    "free_body": (["0.2", "0.1"], "0.1", {**SOLID, **QUALITY}),
    "p_wave": (["0.025"], "0.025", {**SOLID, **hourglass("0", "0.1", "2"), **QUALITY}),
    "p_wave_diagonal": (
        ["0.025"],
        "0.025",
        {"bond_support": ["1.5", "2"], **hourglass("0.1", "2"), "quality": ["reference"]},
    ),
    "cantilever": (
        ["0.25", "0.125", "0.0625"],
        "0.125",
        {**SOLID, **hourglass("0", "0.1", "2"), "elastic_substeps": ["4"], **QUALITY},
    ),
    "cantilever_vibration": (["0.25", "0.125"], "0.125", {**SOLID, **hourglass("0", "0.1", "2"), **QUALITY}),
    "cantilever_modes": (["0.125"], "0.125", {**hourglass("0", "0.1")}),
    "plasticity": (["0.1"], "0.1", {"elastic_precision": ["single"]}),
    "creep": (["0.1"], "0.1", {"elastic_precision": ["single"]}),
    "pressed_block": (
        ["0.01", "0.005"],
        "0.01",
        {"material.paste.law": ["green", "corotated"], "elastic_precision": ["single"]},
    ),
    "slump": (
        ["0.00833333", "0.00625"],
        "0.00833333",
        {"material.paste.law": ["green", "corotated"], "material.paste.hourglass": ["0.1"]},
    ),
    "slump_stiff": (["0.00833333", "0.00625"], "0.00833333", {}),
    "taylor_bar": (
        ["0.0008", "0.000533333", "0.0004"],
        "0.0008",
        {"material.copper.law": ["green", "corotated"], "material.copper.hourglass": ["0.1"]},
    ),
    "slabs": (["0.05", "0.025", "0.0125"], "0.0125", {**HEAT, **PRECISION, "cfl_heat": ["0.4", "0.2"]}),
    "conductivity_ratio": (
        ["0.025", "0.0125", "0.00625"],
        "0.0125",
        {**HEAT, **PRECISION, "cfl_heat": ["0.4", "0.2"], **QUALITY},
    ),
    "sphere_bath": (["0.125", "0.0625"], "0.0625", {**HEAT, **PRECISION}),
    "sphere_biot": (["0.125", "0.0625"], "0.0625", {**KERNELS, **WIDE, "conduction": ["plain"], **PRECISION}),
    "stefan_one_phase": (
        ["0.02", "0.01", "0.005"],
        "0.01",
        {"kernel": ["mcg03"], **WIDE, "conduction": ["plain"], "cfl_heat": ["0.4"], **PRECISION},
    ),
    "stefan_two_phase": (
        ["0.02", "0.01", "0.005"],
        "0.01",
        {"kernel": ["mcg03"], **WIDE, "conduction": ["plain"], "cfl_heat": ["0.4"], **PRECISION},
    ),
    "rosenthal": (["0.05", "0.0333333"], "0.05", {**KERNELS, **WIDE, **PRECISION}),
    "eagar_tsai": (["0.1", "0.05", "0.0333333"], "0.05", {**KERNELS, **WIDE, **PRECISION}),
    "cavity": (
        ["0.05", "0.025"],
        "0.025",
        {"max_density_error": ["0.0025"], "pressure_solver": ["incompressible"]},
    ),
    "cavity_1e5": (["0.025", "0.0166666666666667"], "0.0166666666666667", {}),
    "contact_melting": (["0.001"], "0.001", {}),
    "gallium": (["0.0333333333333333"], "0.0333333333333333", {}),
    # surfaces; targets hold from R/dx = 16 on
    "surface_ball": (["0.125", "0.0625", "0.0416666666666667"], "0.0625", {**SURFACE, **FINE_SURFELS}),
    "surface_ball_relaxed": (["0.125", "0.0625", "0.0416666666666667"], "0.0625", {}),
    "surface_ball_mesh": (["0.125", "0.0625", "0.0416666666666667"], "0.0625", {}),
    "surface_cube": (
        ["0.125", "0.0625"],
        "0.0625",
        {"surface.source": ["particles"], "surface.source=particles surface.adapt": ["0.5"]},
    ),
    "surface_sheet": (
        ["0.125", "0.0625", "0.03125"],
        "0.0625",
        {
            "surface.smoothing": ["plane"],
            "surface.particle_support": ["1", "1.5"],
            "surface.enforce_volume": ["1"],
        },
    ),
    "surface_spin": (["0.25", "0.125"], "0.125", {}),
    "surface_melt": (
        ["0.00833333333333333", "0.00625"],
        "0.00833333333333333",
        {"surface.enforce_volume": ["0"]},
    ),
    "surface_merge": (
        ["0.166666666666667", "0.125", "0.1"],
        "0.125",
        {"surface.enforce_volume": ["1"], "surface.particle_support": ["1.5"]},
    ),
    "surface_split": (
        ["0.166666666666667", "0.125", "0.1"],
        "0.125",
        {
            "material.oil.surface_tension": ["0", "0.03"],
            "body.0.packing": ["lattice"],
            "body.0.packing=lattice material.oil.surface_tension": ["0"],
        },
    ),
    "surface_held": (["0.166666666666667", "0.125", "0.1"], "0.125", {}),
}

# Final particles of these cases are drawn (particles.py), at the spacing of the settings comparison.
PICTURES = ("elliptic_drop", "rotating_patch")


def settingsOf(key, value):
    """[key=value, ...] as `--set` takes them.

    In a key of several words, all but the last carry their own value: "density=continuity support".
    """
    words = key.split()
    words[-1] += "=" + value
    return [
        w if w.startswith(("material.", "quality=", "surface.", "body.")) else "numerics." + w for w in words
    ]


def runs(level):
    """(case, spacing, [numerics key=value, ...]) in the order of the runs.

    Defaults come first, and so do cheap resolutions.
    """
    todo = []
    deepest = max(len(spacings) for spacings, _, _ in CASES.values())
    for k in range(deepest):
        todo += [(case, spacings[k], []) for case, (spacings, _, _) in CASES.items() if k < len(spacings)]
    for case, (spacings, at, axes) in CASES.items():
        choices = [settingsOf(key, value) for key, values in axes.items() for value in values]
        if level == "quick":
            todo += [(case, at, c) for c in choices]
        else:
            pairs = [
                a + b
                for a, b in combinations(choices, 2)
                if not {w.split("=")[0] for w in a} & {w.split("=")[0] for w in b}
            ]
            todo += [(case, s, c) for s in spacings for c in choices + pairs]
    return todo
