"""What docs/cluster.md tells to run does run, with stand-ins for SLURM and Kubernetes."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
import yaml
from pages import PAGES, blocks, shown

from soccersim.regress.store import Store

HERE = Path(__file__).parents[1] / "docs" / "examples" / "cluster"
FILES = [
    block for block in blocks("bash", "dockerfile", "yaml") if "file=examples/cl" in block.info
]
SBATCH = """\
#!/bin/bash
script="${@: -1}"
array=$(sed -n 's/^#SBATCH --array=//p' "$script")
for task in $(seq ${array/-/ }); do SLURM_ARRAY_TASK_ID=$task bash "$script" >&2 || exit; done
[ -n "$array" ] || bash "$script" >&2 || exit
echo 17
"""
SRUN = """\
#!/bin/bash
exec "$@"
"""
SMALLER = {  # what the examples ask for, and what is played here
    "--pairs 6400": "--pairs 2",
    "--pairs=6400": "--pairs=2",
    "--duration 60": "--duration 2",
    "--duration=60": "--duration=2 --pairs=2",
    "SHARDS=64": "SHARDS=2",
    "))/64": "))/2",
    "--array=1-64": "--array=1-2",
    "msl-match": "friendly-match",
}
posix = pytest.mark.skipif(os.name != "posix", reason="bash")


def documents(name):
    return list(yaml.safe_load_all((HERE / name).read_text(encoding="utf-8")))


def smaller(text):
    for long, short in SMALLER.items():
        text = text.replace(long, short)
    return text


@pytest.fixture
def place(tmp_path, monkeypatch):
    """A folder with a team, a home with soccersim in it, and stand-ins for SLURM's programs."""
    (tmp_path / "my_team.py").write_text(
        "from soccersim.strategy import Command, Strategy\n\n"
        "class Mine(Strategy):\n    def decide(self, view):\n"
        "        return [Command(0.3) for _ in view.robots]\n"
    )
    programs = tmp_path / "soccersim" / "bin"
    programs.mkdir(parents=True)
    (programs / "activate").write_text("")
    for name, text in (("sbatch", SBATCH), ("srun", SRUN)):
        (programs / name).write_text(text)
        (programs / name).chmod(0o755)
    path = os.pathsep.join([str(programs), str(Path(sys.executable).parent), os.environ["PATH"]])
    cache = os.environ.get("SOCCERSIM_CACHE") or str(Path.home() / ".cache" / "soccersim")
    (tmp_path / "tmp").mkdir()
    told = {"PATH": path, "SOCCERSIM_CACHE": cache, "HOME": tmp_path, "TMPDIR": tmp_path / "tmp"}
    for name, value in told.items():
        monkeypatch.setenv(name, str(value))
    for path in HERE.glob("*.sbatch"):
        (tmp_path / path.name).write_text(smaller(path.read_text(encoding="utf-8")))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def bash(script, **environment):
    done = subprocess.run(
        ["bash", "-c", script], capture_output=True, text=True, env={**os.environ, **environment}
    )
    assert done.returncode in (0, 1), done.stdout + done.stderr  # 1: FAIL
    return done


def table(path):
    """All rows but for their keys, which change where somebody edits soccersim meanwhile."""
    with Store(path) as store:
        return [row.result[1:] for row in store.rows()]


@pytest.mark.parametrize("block", FILES, ids=lambda block: block.info)
def test_files_shown_are_the_files(block):
    assert block.text == shown(block), "is out of date: run `python tests/pages.py`"


def test_every_example_is_shown():
    named = {block.info.rpartition("/")[2] for block in FILES}
    assert named == {path.name for path in HERE.iterdir()}


@posix
@pytest.mark.parametrize("path", sorted(HERE.glob("*.sbatch")), ids=lambda path: path.name)
def test_bash_understands_the_scripts(path):
    subprocess.run(["bash", "-n", str(path)], check=True)
    options = re.findall(r"^#SBATCH (\S+)", path.read_text(encoding="utf-8"), re.MULTILINE)
    assert options
    assert all(re.fullmatch(r"--[a-z-]+(=\S+)?", option) for option in options)


@posix
def test_bash_understands_what_the_page_tells_to_type():
    for block in blocks("bash"):
        if block.page == next(page for page in PAGES if page.name == "cluster.md"):
            subprocess.run(["bash", "-n"], input=block.text, text=True, check=True)


def test_kubernetes_files_fit_together():
    claim, shards = documents("kubernetes-shards.yaml")
    (merge,) = documents("kubernetes-merge.yaml")
    cluster, coordinator = documents("kubernetes-dask.yaml")
    images = set()
    for job in (shards, merge, coordinator):
        pod = job["spec"]["template"]["spec"]
        (container,) = pod["containers"]
        images.add(container["image"])
        volumes = {volume["name"]: volume for volume in pod["volumes"]}
        assert {mount["name"] for mount in container["volumeMounts"]} == set(volumes)
        results = volumes["results"]["persistentVolumeClaim"]["claimName"]
        assert results == claim["metadata"]["name"]
    assert shards["spec"]["completionMode"] == "Indexed"
    assert (
        f"/{shards['spec']['completions']}"
        in shards["spec"]["template"]["spec"]["containers"][0]["args"][0]
    )
    name, spec = cluster["metadata"]["name"], cluster["spec"]
    service = spec["scheduler"]["service"]
    assert service["selector"] == {
        "dask.org/cluster-name": name,
        "dask.org/component": "scheduler",
    }
    (scheduler,), (worker,) = (spec[part]["spec"]["containers"] for part in ("scheduler", "worker"))
    ports = {port["name"]: port["containerPort"] for port in scheduler["ports"]}
    assert {port["targetPort"]: port["port"] for port in service["ports"]} == ports
    assert f"--scheduler=tcp://{name}-scheduler:{ports['tcp-comm']}" in container["args"]
    assert {scheduler["image"], worker["image"], *images} == {
        "registry.example.org/soccersim:0.1.0"
    }


@posix
@pytest.mark.slow
def test_the_batch_scripts_and_the_pods_play_one_table(place):
    bash('job=$(sbatch --parsable shards.sbatch); sbatch --dependency="afterok:$job" merge.sbatch')
    assert (place / "report.html").stat().st_size > 1000
    shards = table(place / "all.db")
    assert len(shards) == 4
    for file in ("all.db", "report.html"):
        (place / file).unlink()

    dask = smaller((HERE / "dask.sbatch").read_text()).replace(
        "--duration 2", "--duration 2 --pairs 2"
    )
    bash(dask, SLURM_JOB_ID="17", SLURM_CPUS_PER_TASK="1")
    assert table(place / "results.db") == shards
    assert not (place / "scheduler-17.json").exists()

    (place / "results").mkdir()
    for index in range(2):
        bash(pod("kubernetes-shards.yaml", 1, place), JOB_COMPLETION_INDEX=str(index))
    bash(pod("kubernetes-merge.yaml", 0, place))
    assert table(place / "results" / "all.db") == shards
    (place / "results" / "report.html").unlink()

    spec = documents("kubernetes-dask.yaml")[0]["spec"]
    scheduler, worker = (
        " ".join(spec[part]["spec"]["containers"][0]["args"]) for part in ("scheduler", "worker")
    )
    file = place / "scheduler.json"
    worker = worker.replace("$(DASK_WORKER_NAME)", "one").replace("--nthreads=4", "--nthreads=1")
    regress = pod("kubernetes-dask.yaml", 1, place)
    regress = re.sub(r"tcp://[\w-]+:8786", f"file:{file}", regress)
    bash(
        f"trap 'kill $(jobs -p)' EXIT\n"
        f"{scheduler} --port 0 --dashboard-address :0 --scheduler-file {file} &\n"
        f"until [ -s {file} ]; do sleep 0.2; done\n"
        f"{worker} --scheduler-file {file} --local-directory {place}/tmp &\n{regress}"
    )
    assert table(place / "results" / "results.db") == shards


def pod(name, at, place):
    """The command of a pod, for bash."""
    container = documents(name)[at]["spec"]["template"]["spec"]["containers"][0]
    return smaller(" ".join(container["args"])).replace("/results/", f"{place}/results/")
