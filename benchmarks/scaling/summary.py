# SPDX-License-Identifier: Apache-2.0
"""Terminal output of the scaling study, and the machine of its model."""
import model


def machineOf(path):
    """Machine with the measured rate of a core while others compute.

    All else are the model's inputs for a cluster.
    """
    weak = model.read(path, "weak")
    return (
        model.Machine(rate=1e6 * weak[-1]["copies_msteps_per_s"] / weak[-1]["ranks"])
        if weak
        else model.Machine()
    )


def summary(path):
    """Lines for the terminal."""
    lines = []
    for series in ("strong", "weak"):
        for r in model.read(path, series):
            target = f"   target {r['target_efficiency']}" if r["target_efficiency"] else ""
            lines.append(
                f"{series:7s} {r['ranks']:3.0f} ranks {r['particles']:10.0f} particles "
                f"{r['ms_step']:9.2f} ms a step  {r['msteps_per_s']:7.2f} M particle-steps/s  "
                f"efficiency {r['efficiency']:.3f}{target}  imbalance {r['imbalance']:.3f}"
            )
    for r in model.read(path, "corner", "corner"):
        lines.append(
            f"corner  {r['ranks']:3.0f} ranks {r['particles']:10.0f} particles "
            f"{r['ms_step']:9.2f} ms a step  imbalance {r['imbalance']:.3f}   "
            f"target {r['target_imbalance']}  (worst 25 steps {r['imbalance_worst']:.3f})"
        )
    for case in ("fluid", "corner"):
        for r in model.read(path, "counts", case):
            lines.append(
                f"counts  {r['ranks']:3.0f} ranks {r['particles']:10.0f} particles of {case}: "
                f"a step and rank {r['messages']:.1f} messages (most {r['messages_max']:.1f}), "
                f"{r['kib']:.0f} KiB (most {r['kib_max']:.0f}), {r['collectives']:.2f} collectives; "
                f"ghosts / own {r['halo_fraction']:.2f}"
            )
    return "\n".join(lines)
