"""The figures of docs/million-matches.md, of this machine: `python tests/benchmarks/million.py`.

Processor time where that can be, since other programs may run at the same time.
"""

import json
import os
import pickle
import resource
import subprocess
import sys
import time
import zlib
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

HERE = Path(__file__).parent
sys.path[:0] = [str(HERE), str(HERE.parent / "regress")]

TEAMS = "roles", "chaser"
LEGS = 1000  # played by nobody, to see what it costs to hand them out


def spent(who=resource.RUSAGE_SELF):
    """Processor time of this process, or of its children that have ended."""
    used = resource.getrusage(who)
    return used.ru_utime + used.ru_stime


def cold(scenario, seconds, folder):
    """Processor time of a match in processes of its own, and the bytes of its recording."""
    words = [*TEAMS, "--scenario", scenario, "--duration", str(seconds), "--seed", "1"]
    before = spent(resource.RUSAGE_CHILDREN)
    subprocess.run(
        [sys.executable, "-m", "soccersim", "match", *words, "--out", folder, "--force", "--json"],
        check=True,
        capture_output=True,
    )
    size = Path(folder, "recording.npz").stat().st_size
    return spent(resource.RUSAGE_CHILDREN) - before, size


def matches(folder):
    """What a second of play costs, as the difference of two lengths."""
    for scenario in ("msl-match", "friendly-match"):
        cold(scenario, 1, folder)  # compiles
        short, long = ([cold(scenario, s, folder) for _ in range(3)] for s in (60, 300))
        used = (min(long)[0] - min(short)[0]) / 240
        size = (long[0][1] - short[0][1]) / 240
        print(f"{scenario}: {used:.4f} s of processor a second of play, {size / 1e3:.2f} kB")


def legs(count, seconds=60, scenario="msl-match"):
    from soccersim import load_scenario
    from soccersim.regress.bundle import bundle
    from soccersim.regress.leg import pair_of

    spec = load_scenario(scenario, settings=[f"duration={seconds}"])
    teams = tuple(map(bundle, TEAMS))
    return [leg for n in range(count // 2) for leg in pair_of(spec, teams, n, n + 1)]


def local(folder):
    """What the pool, the process and the store add to matches of 60 s, in time on the clock."""
    from soccersim.regress.ground import Ground
    from soccersim.regress.pool import LocalPool
    from soccersim.regress.runner import run
    from soccersim.regress.store import Store

    asked, path = legs(24), Path(folder, "local.db")
    with Store(path) as store, LocalPool(1, Ground(asked[0].scenario)) as pool:
        start = time.perf_counter()
        rows = [row for _, row in run(asked, store, pool)]
        took = time.perf_counter() - start
    overhead = sorted(row.overhead for row in rows)[len(rows) // 2]
    played = sorted(row.seconds for row in rows)[len(rows) // 2]
    print(
        f"one job: {played:.2f} s a match, {overhead:.2f} s around it, {took:.1f} s for {len(rows)}"
    )
    return rows


def rows_kept(rows, folder):
    """Rows a second that the store takes, and the bytes of one."""
    from soccersim.regress.store import Store

    count, path = 2000, Path(folder, "rows.db")
    with Store(path) as store:
        start, before = time.perf_counter(), spent()
        for at in range(count):
            store.add(replace(rows[at % len(rows)], key=f"{at:064x}", pair=at // 2, leg=at % 2))
        took, used = time.perf_counter() - start, spent() - before
    size = path.stat().st_size / count
    print(f"store: {count / took:.0f} rows a second, {1e3 * used / count:.2f} ms of processor, ")
    print(f"       {size:.0f} bytes a row")
    start = time.perf_counter()
    with Store(path) as store:
        found = sum(1 for _ in store.rows())
    print(f"       {found / (time.perf_counter() - start):.0f} rows a second are read")


def instant(task, seed):
    """In place of remote.play: a match that is over at once."""
    from soccersim.regress.job import Played, void_row

    leg, _ = pickle.loads(zlib.decompress(task))
    return Played(replace(void_row(leg, ""), digest=leg.key, events=({"kind": "goal"},) * 20))


def coordinator(folder):
    """What the coordinator and Dask's scheduler do for a leg."""
    import million
    from dask_cluster import Programs

    from soccersim.regress import cluster
    from soccersim.regress.remote import packed
    from soccersim.regress.runner import run
    from soccersim.regress.store import Store

    os.environ["PYTHONPATH"] = os.pathsep.join(sys.path)
    asked = legs(LEGS)
    print(f"a task: {len(packed(asked[0], False))} bytes")
    programs = Programs(Path(folder, "dask"))
    programs.worker("--nthreads", "16")
    cluster.play = million.instant
    try:
        with (
            Store(Path(folder, "dask.db")) as store,
            cluster.cluster_pool(programs.address, asked[0].scenario) as pool,
        ):
            time.sleep(15)  # the worker has loaded what it does not use here
            before, served = spent(), ticks(programs.scheduler.pid)
            start = time.perf_counter()
            for _ in run(asked, store, pool):
                pass
            took = time.perf_counter() - start
            used, serving = spent() - before, ticks(programs.scheduler.pid) - served
        print(
            f"coordinator: {LEGS / took:.0f} legs a second, {1e3 * used / LEGS:.2f} ms of processor"
        )
        print(f"scheduler: {1e3 * serving / LEGS:.2f} ms of processor a leg", flush=True)
    finally:
        programs.close()


def ticks(pid):
    """Processor time of a process that runs."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def main():
    with TemporaryDirectory() as folder:
        if sys.argv[1:] == ["coordinator"]:
            return coordinator(folder)
        matches(folder)
        played = local(folder)
        print(f"a result: {len(pickle.dumps(played)) / len(played):.0f} bytes")
        rows_kept(played, folder)
        coordinator(folder)
        print(json.dumps({"load": os.getloadavg(), "processors": os.cpu_count()}))


if __name__ == "__main__":
    main()
