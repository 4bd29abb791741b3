"""Batches as Slurm arrays, by an sbatch that runs the tasks of an array one after the other."""
import json
import os

from conftest import FOURPOST, STUB, content

SBATCH = """#!/bin/sh
# The first of all tasks is lost.
for word; do case $word in --array=0-*) last=${word#--array=0-};; --output=*) output=${word#--output=};; esac; done
for share in $(seq 0 $last); do
  [ -e FOLDER/killed ] || { : > FOLDER/killed; continue; }
  SLURM_ARRAY_TASK_ID=$share FOURPOST_PROGRAM=PROGRAM sh "$word" > "$output" 2>&1
done
echo 7
"""


def prepared(batch, program=STUB):
    """Words of the environment with which sbatch is found."""
    (batch.folder / "bin").mkdir(exist_ok=True)
    file = batch.folder / "bin/sbatch"
    file.write_text(SBATCH.replace("FOLDER", str(batch.folder)).replace("=PROGRAM", f"={program}"))
    file.chmod(0o755)
    # All tasks have ended when sbatch does.
    (batch.folder / "bin/squeue").symlink_to("/bin/true")
    return {"PATH": f"{batch.folder}/bin:{os.environ['PATH']}"}


def test_results_are_those_of_a_serial_run(starter):
    """With the real program, as its tasks call it; the first of all tasks is lost and comes again."""
    starter.write("plan.yaml", "fits: [{study: car/study.yaml, seeds: 1..4}]\n"
                               "predictions: [{of: study, recordings: car/stepped_sine.csv}]\n")
    starter.run("--output=serial", program=FOURPOST)
    answer = starter.json("--output=out", "--on=slurm", "--workers=2", program=FOURPOST, **prepared(starter, FOURPOST))
    assert answer["work"] == {"found": 0, "paid": 8, "tried_again": 2}
    assert content(starter.folder / "out") == content(starter.folder / "serial")


def test_workers_of_another_build_are_refused(batch):
    batch.study("a.yaml", "delay 0")
    other = batch.write("other", STUB.read_text() + "# Another build.\n")
    other.chmod(0o755)
    batch.write("plan.yaml", "comparisons: [{study: a.yaml, seeds: 1..4}]")
    environment = prepared(batch, other)
    outcome = batch.run("--output=out", "--on=slurm", "--json", code=75, **environment)
    assert "[batch-worker-of-other-build]" in outcome.stderr
    assert json.loads(outcome.stdout)["warnings"][0]["id"] == "batch-worker-of-other-build"


def test_a_scheduler_that_does_not_answer_is_said(batch):
    batch.study("a.yaml", "delay 0")
    batch.write("plan.yaml", "comparisons: [{study: a.yaml, seeds: 1..4}]")
    environment = prepared(batch)
    (batch.folder / "bin/sbatch").write_text("#!/bin/sh\necho 'sbatch: error: Unable to contact slurm controller' >&2\nexit 1\n")
    said = batch.run("--output=out", "--on=slurm", code=75, **environment).stderr
    assert "Unable to contact slurm controller" in said and "[batch-scheduler-away]" in said


def test_a_refusal_has_the_words_of_sbatch(batch):
    batch.study("a.yaml", "delay 0")
    batch.write("plan.yaml", "comparisons: [{study: a.yaml, seeds: 1..4}]")
    environment = prepared(batch)
    refusal = "sbatch: error: invalid partition specified: lang"
    (batch.folder / "bin/sbatch").write_text(f"#!/bin/sh\necho '{refusal}' >&2\nexit 1\n")
    said = batch.run("--output=out", "--on=slurm", code=2, **environment).stderr
    assert f"Slurm refuses the array: {refusal}: correct " in said and "[batch-slurm-refuses]" in said
    said = batch.run("--output=out", "--on=slurm", "--slurm=--time '4", code=2, **environment).stderr
    assert "No closing quotation in '--time '4': correct " in said
