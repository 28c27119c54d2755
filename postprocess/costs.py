"""What a campaign came to, as text for a page: how many checks passed at what cost, and the runs of one case with what each took."""


def programs(runs):
    """The commits of the programs that made these runs: "commit 0123abc"; a program that was built from changed sources is said to be."""
    made = [run["provenance"] for run in runs if run.get("provenance")]
    commits = dict.fromkeys(p.get("commit", "unknown")[:7] + (" with changes" if p.get("dirty") == "yes" else "") for p in made)
    return ("commits " if len(commits) > 1 else "commit ") + (", ".join(commits) or "unknown")


def seconds(value):
    """Three digits, without exponents."""
    return "–" if value is None else f"{value:.0f}" if value >= 100 else f"{value:.3g}" if value >= 0.001 else "0"


def quoted(word):
    """An argument of a run as a shell takes it; none holds both kinds of quotes."""
    return f'"{word}"' if "'" in word else f"'{word}'" if set(word) & set(' "[]()*') else word


def command(campaign, case=""):
    return f"`build/release/bin/verify run{case and ' ' + case} --suite {campaign['suite']}`"


def sentence(campaign):
    """Checks and cost of a whole campaign, one sentence a line. Wall time is that of a campaign in which every run was made anew."""
    checks = [(case["case"], check) for case in campaign["cases"] for check in case["checks"]]
    runs = [run for case in campaign["cases"] for run in case["runs"]]
    failed = [f"{case}, {check['name']} ({check['status']})" for case, check in checks if check["status"] != "pass"]
    of_plans = sum(check["name"].startswith("forecast, ") for _, check in checks)
    wall = "" if any(run.get("reused") for run in runs) else f" in {seconds(campaign['wall_s'])} s of wall on {campaign['cores']} cores"
    cpu = seconds(sum(run["cpu_s"] for run in runs))
    yield f"{command(campaign)}, {programs(runs)}: {len(campaign['cases'])} cases, {len(runs)} runs, {cpu} s of CPU{wall};"
    outcome = "all passed" if not failed else f"{len(checks) - len(failed)} passed, not these: {'; '.join(failed)}"
    yield f"{len(checks)} checks ({of_plans} of them forecasts of runs), {outcome}."


def of_runs(verdict):
    """The runs of a case, dearest first, with what was set, their size and their cost."""
    runs = sorted(verdict["runs"], key=lambda run: -run["cpu_s"])
    yield f"{command(verdict, verdict['case'])}, {programs(runs)}, {seconds(sum(run['cpu_s'] for run in runs))} s of CPU in all:"
    yield ""
    yield "| run | solver | scene | steps | points | CPU s | wall s | MB |"
    yield "|---|---|---|---|---|---|---|---|"
    for run in runs:
        changed = " ".join("--set " + quoted(one) for one in run["set"])
        size = [f"{run[of]:.0f}" if run.get(of) else "–" for of in ("steps", "points")]
        cost = [seconds(run["cpu_s"]), seconds(run["wall_s"]), f"{run['peak_rss_bytes'] / 1e6:.0f}"]
        scene = run["scene"] + (f" `{changed}`" if changed else "")
        yield "| " + " | ".join([run["name"], run["solver"], scene, *size, *cost]) + " |"
