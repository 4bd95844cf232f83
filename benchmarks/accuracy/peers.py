# SPDX-License-Identifier: Apache-2.0
"""Figures of other programs and plain methods, drawn as marks in the charts.

MARKS maps case -> norm -> list of (name, error or None, core-seconds or None). Sources: files in the
repositories of the programs, or small scripts that implement the plain methods (these have no time)."""

MARKS = {
    "slabs": {"L2(T)": [("plain SPH, 1D: a floor", 1.5e-3, None)]},
    "conductivity_ratio": {
        "Linf(T)": [("harmonic mean, 1D, N = 40", 0.008, None), ("arithmetic mean, 1D, N = 160", 0.029, None)]
    },
    "stefan_one_phase": {
        "front": [("enthalpy, 1D: a floor", 0.011, None), ("without latent heat", 0.24, None)]
    },
    "stefan_two_phase": {"front": [("enthalpy, 1D: a floor", 0.011, None)]},
    "hydrostatic": {"L2(p)": [("PySPH's tank (time only)", None, 120)]},
    "martin_moyce": {
        "RMS(Z)": [("PySPH in 2D (time only)", None, 1800), ("PySPH in 3D (time only)", None, 50400)]
    },
    "poiseuille": {"L2(u)": [("SPHinXsys, kinetic energy, H/dx = 20", 0.017, None)]},
    "taylor_green": {"|E/E_exact - 1|": [("SPHinXsys, L/dx = 100", 0.545, None)]},
    "taylor_green_50": {"|E/E_exact - 1|": [("SPHinXsys, L/dx = 100", 0.545, None)]},
    "spinning_drop": {"loss of angular momentum": [("mu grad v, not symmetric", 5, None)]},
    "drop_laplace": {
        "pressure jump": [
            ("colour field as printed, R/dx = 5", 1.6, None),
            ("R/dx = 8", 2.7, None),
            ("R/dx = 12", 4.4, None),
            ("R/dx = 16", 6.1, None),
            ("kappa = -div n, h = 2 dx: worst", 0.11, None),
            ("best", 0.02, None),
        ]
    },
    "patch": {
        "Linf(grad u)": [("MLS on a jittered lattice", 1e-13, None), ("plain SPH at faces", 0.478, None)]
    },
    "rotation": {"Linf(strain)": [("MLS", 1e-14, None)]},
    "p_wave": {
        "P speed at 10 dx": [("MLS, h = 2 dx", 0.065, None), ("h = 3 dx", 0.13, None)],
        "P speed at 20 dx": [("MLS, h = 2 dx", 0.016, None), ("h = 3 dx", 0.035, None)],
        "P speed at 40 dx": [("MLS, h = 2 dx", 0.0041, None), ("h = 3 dx", 0.0088, None)],
    },
    "cantilever": {
        "deflection": [
            ("MLS, h = 2 dx, H/dx = 8", 0.15, None),
            ("MLS, h = 1.5 dx, hourglass 1, H/dx = 8", 0.043, None),
        ]
    },
    "cantilever_vibration": {"first frequency": [("MLS, h = 2 dx, H/dx = 8", 0.067, None)]},
    "surface_ball": {
        "Hausdorff/R": [
            ("iso-surface of a sampled ball, R/dx = 8", 0.032, None),
            ("the same, R/dx = 16", 0.017, None),
            ("the same, R/dx = 24", 0.014, None),
        ],
        "normals mean (deg)": [("colour field at h = 2 dx", 8, None)],
        "normals max (deg)": [("colour field at h = 2 dx", 18, None)],
    },
}
