#!/usr/bin/env python3
"""Writes docs/scaling.md from text.md and the figures: document.py SCALING.csv. Every measured or predicted number in it comes from the file.

In text.md: {{machine}}, {{strong}}, {{weak}}, {{corner}}, {{counts CASE}}, {{fit}}, {{inputs}}, {{predictions}}, {{provisional}} and {{check}} (the model against what this machine did).
"""
import os
import re
import shutil
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import model

DOCS = os.path.join(HERE, "..", "..", "docs")


def table(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|---" * len(head) + "|"] + ["| " + " | ".join(r) + " |" for r in rows])


def reached(value, target, atLeast=True):
    return "reached" if (value >= target if atLeast else value <= target) else "**missed**"


def machineOf(path):
    """The rate is that of a core beside others that compute as well, as measured; the rest are the model's inputs for a cluster."""
    weak = model.read(path, "weak")
    return model.Machine(rate=1e6 * weak[-1]["copies_msteps_per_s"] / weak[-1]["ranks"]) if weak else model.Machine()


def scaled(path, series):
    rows = model.read(path, series)
    if not rows:
        return "not measured"
    lines = []
    for r in rows:
        against = f"{100 * r['efficiency']:.1f} %" if r["ranks"] > 1 else ""
        lines.append([f"{r['ranks']:.0f}", f"{r['particles']:,.0f}", f"{r['ms_step']:.1f}", f"{r['msteps_per_s']:.2f}", f"{r['copies_msteps_per_s']:.2f}", against, f"{100 * r['speedup'] / r['ranks']:.1f} %",
                      f"{r['imbalance']:.3f}", f"{100 * r['halo_fraction']:.1f} %", f"{r['messages']:.1f}", f"{r['kib']:,.0f}", f"{r['collectives']:.2f}", f"{r['ms_wait']:.2f}"])
    last = rows[-1]
    text = table(["ranks", "particles", "ms a step", "M particle-steps/s", "of copies", "efficiency against copies", "against one rank alone", "imbalance", "ghosts / own", "messages", "KiB", "collectives",
                  "ms waiting"], lines)
    return text + f"\n\n{last['efficiency']:.1%} on {last['ranks']:.0f} ranks; target {last['target_efficiency']:.0%}: {reached(last['efficiency'], last['target_efficiency'])}."


def corner(path):
    rows = model.read(path, "corner", "corner")
    if not rows:
        return "not measured"
    said = []
    for r in rows:
        shared = r.get("clock") == "cpu"
        said.append(f"{r['particles']:,.0f} particles on {r['ranks']:.0f} ranks{' that share ' + format(r['cores'], '.0f') + ' cores, work by the CPU time of each,' if shared else ''} over {r['steps']:.0f} steps: "
                    f"imbalance {r['imbalance']:.3f} (largest over mean work of a rank), in the worst 25 steps {r['imbalance_worst']:.3f}; "
                    f"target below {r['target_imbalance']}: over the run {reached(r['imbalance'], r['target_imbalance'], False)}, in its worst window {reached(r['imbalance_worst'], r['target_imbalance'], False)}. "
                    f"The largest share of particles is {r['particles_max_over_mean']:.2f} times the mean." + ("" if shared else f" The balance takes {r['ms_balance']:.3f} ms a step of {r['ms_step']:.1f} ms."))
    return "\n\n".join(said)


def counts(path, case):
    rows = model.read(path, "counts", case)
    lines = [[f"{r['ranks']:.0f}", f"{r['particles']:,.0f}", f"{100 * r['halo_fraction']:.0f} %", f"{r['neighbours']:.1f} ({r['neighbours_max']:.0f})", f"{r['messages']:.1f} ({r['messages_max']:.1f})",
              f"{r['messages_bonds']:.1f}", f"{r['kib_ghosts']:.0f}", f"{r['kib_refresh']:.0f}", f"{r['kib_bonds']:.0f}", f"{r['kib_migration']:.2f}", f"{r['kib_max']:.0f}", f"{r['collectives']:.2f}"] for r in rows]
    return table(["ranks", "particles", "ghosts / own", "neighbours (most)", "messages (most)", "along bonds", "KiB of ghosts", "of refreshes", "along bonds", "of migration", "most of a rank", "collectives"], lines)


def fitted(path):
    c = model.fit(model.read(path))
    return (f"a layer of ghosts {c.layer:.2f} particles thick, {c.bytes_per_ghost:.0f} bytes a ghost and step, {c.messages:.2f} messages a neighbour and step, {c.collectives:.2f} collectives a step and "
            f"{c.growth:.3f} more for each doubling of ranks")


def inputs(path):
    m = machineOf(path)
    return table(["input", "value", "what it stands for"], [
        ["`--rate`", f"{m.rate:.3g} particle-steps/s", "a core, beside others that compute (measured here)"],
        ["`--latency`", f"{1e6 * m.latency:g} us", "a message between nodes"],
        ["`--bandwidth`", f"{m.bandwidth / 1e9:g} GB/s", "a rank's share of a node's network: 25 GB/s for 64 ranks"],
        ["`--collective`", f"{1e6 * m.collective:g} us", "a small reduction, for each doubling of ranks"],
        ["`--table`", f"{1e6 * m.table:g} us", "a rank and new partition: tables of rank size, splits of communicators"],
        ["`--partition`", f"{m.partition:g} steps", "from one new partition to the next; the balance allows no more often"],
        ["`--imbalance`", f"{m.imbalance:g}", "largest over mean work"],
        ["`--ghost-work`", f"{m.ghost_work:g}", "work of a ghost, in that of an own particle"],
        ["`--overlap`", f"{m.overlap:g}", "share of the exchange behind work; 0: none, which is careful"]])


def predictions(path):
    c, m = model.fit(model.read(path)), machineOf(path)
    lines = []
    for particles, ranks in ((1e6, 4), (1e7, 64), (1e8, 64), (1e8, 1000), (1e9, 1000), (1e9, 10000), (1e10, 1000), (1e10, 10000)):
        s = model.step(c, m, particles, ranks)
        parts = s["parts"]
        lines.append([f"{particles:.0e}", f"{ranks:,}", f"{particles / ranks:,.0f}", f"{1e3 * s['seconds']:.1f}", f"{100 * model.efficiency(c, m, particles, ranks):.1f} %", f"{s['messages']:.0f}", f"{s['bytes'] / 2**20:.2f}",
                      *(f"{1e3 * parts[p]:.2f}" for p in ("ghosts", "exchange", "collectives", "tables"))])
    return table(["particles", "ranks", "a rank", "ms a step", "efficiency", "messages a rank", "MiB a rank", "ms ghosts", "ms exchange", "ms collectives", "ms tables"], lines)


def check(path):
    """With the latency and bandwidth of shared memory: what the model says of the runs that were timed."""
    c, lines, base = model.fit(model.read(path)), [], machineOf(path)
    for series in ("strong", "weak"):
        for r in model.read(path, series):
            if r["ranks"] < 2:
                continue
            own = model.Machine(rate=1e6 * r["copies_msteps_per_s"] / r["ranks"], latency=1e-6, bandwidth=2e9, collective=2e-6, imbalance=r["imbalance"], ghost_work=base.ghost_work)
            predicted = 1e3 * model.step(c, own, r["particles"], r["ranks"])["seconds"]
            lines.append([series, f"{r['ranks']:.0f}", f"{r['particles']:,.0f}", f"{r['ms_step']:.1f}", f"{predicted:.1f}", f"{100 * (predicted / r['ms_step'] - 1):+.1f} %"])
    return table(["series", "ranks", "particles", "ms measured", "ms by the model", "off by"], lines)


def summary(path):
    """For the terminal."""
    lines = []
    for series in ("strong", "weak"):
        for r in model.read(path, series):
            target = f"   target {r['target_efficiency']}" if r["target_efficiency"] else ""
            lines.append(f"{series:7s} {r['ranks']:3.0f} ranks {r['particles']:10.0f} particles {r['ms_step']:9.2f} ms a step  {r['msteps_per_s']:7.2f} M particle-steps/s  efficiency {r['efficiency']:.3f}{target}  imbalance {r['imbalance']:.3f}")
    for r in model.read(path, "corner", "corner"):
        lines.append(f"corner  {r['ranks']:3.0f} ranks {r['particles']:10.0f} particles {r['ms_step']:9.2f} ms a step  imbalance {r['imbalance']:.3f}   target {r['target_imbalance']}  (worst 25 steps {r['imbalance_worst']:.3f})")
    for case in ("fluid", "corner"):
        for r in model.read(path, "counts", case):
            lines.append(f"counts  {r['ranks']:3.0f} ranks {r['particles']:10.0f} particles of {case}: a step and rank {r['messages']:.1f} messages (most {r['messages_max']:.1f}), {r['kib']:.0f} KiB (most {r['kib_max']:.0f}), "
                         f"{r['collectives']:.2f} collectives; ghosts / own {r['halo_fraction']:.2f}")
    return "\n".join(lines)


def machineLine(path):
    rows = [r for s in ("strong", "weak", "corner", "counts") for r in model.read(path, s, "corner" if s == "corner" else "fluid")]
    where = {}
    for r in rows:
        where.setdefault((r["machine"], r["version"]), []).append(r["series"])
    return "; ".join(f"{' and '.join(dict.fromkeys(series))} on {machine} with thaw {version}" for (machine, version), series in where.items())


def provisional(path):
    """Said where the figures are not those of the full study."""
    rows = [r for s in ("strong", "weak", "corner", "counts") for r in model.read(path, s, "corner" if s == "corner" else "fluid")]
    return "" if all(r["level"] == "full" for r in rows) else "\n\n**Provisional: times of short runs on a machine that was busy with other work. Counts do not depend on that: where they are measured, cells stay where the start puts them.**"


def write(path):
    folder = os.path.join(DOCS, "scaling")
    os.makedirs(folder, exist_ok=True)
    kept = os.path.join(folder, "scaling.csv")
    if os.path.abspath(path) != os.path.abspath(kept):
        shutil.copy(path, kept)
    made = {"machine": machineLine, "strong": lambda p: scaled(p, "strong"), "weak": lambda p: scaled(p, "weak"), "corner": corner, "fit": fitted, "inputs": inputs, "predictions": predictions, "check": check, "provisional": provisional}
    with open(os.path.join(HERE, "text.md")) as f:
        text = f.read()
    text = re.sub(r"\{\{(\w+)\s*(\w*)\}\}", lambda m: counts(path, m[2]) if m[1] == "counts" else made[m[1]](path), text)
    with open(os.path.join(DOCS, "scaling.md"), "w") as f:
        f.write(text)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    write(sys.argv[1])
