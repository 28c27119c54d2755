"""Beside Figs. 13 to 15: a slender dendrite whose tip the mesh resolves, compressed."""

import compression


def slender(results):
    run = results.record("compress_dendrite_slender", "mpm_pf")
    last = max(share for share in (0.05, 0.10) if run.table("melt")["compression"].max() >= share)
    return compression.field_table(run, (0.0, 0.05, 0.10) if last == 0.10 else (0.0, 0.05))


FIGURES = {"slender": slender}
