"""Results under their keys: whole or not there, in any order, by any number of writers."""
import os
import signal
import subprocess
import sys
import time

import pytest
from conftest import SOURCE

from fourpost_batch import BatchError, Store
from fourpost_batch.store import file_hash
from fourpost_batch.unit import read_result, result_text

RESULT = {"code": 0, "printed": "1\n", "files": {"a": "x\udcff"}, "messages": []}
KEY = "ab" * 32


def test_a_result_comes_back(tmp_path):
    store = Store.make(tmp_path / "out")
    assert store.get(KEY) is None
    store.put(KEY, result_text(KEY, RESULT))
    assert store.get(KEY) == RESULT and list(store.keys()) == [KEY] and not store.damaged
    assert Store.make(tmp_path / "out").id == store.id != ""


def test_an_altered_result_is_none(tmp_path):
    store = Store.make(tmp_path)
    text = result_text(KEY, RESULT)
    for altered in (text.replace(b'"1\\n"', b'"2\\n"'), text[:-20], b"", b"[]", text.replace(b"abab", b"abac")):
        assert altered != text
        store.put(KEY, altered)
        store.damaged.clear()
        assert store.get(KEY) is None and store.damaged == {KEY}
    assert read_result("cd" * 32, text) is None


def test_a_folder_of_others_is_refused(tmp_path):
    (tmp_path / "photo.jpg").write_text("")
    with pytest.raises(BatchError) as refused:
        Store.make(tmp_path)
    assert refused.value.findings[0].id == "batch-folder-other"
    assert [path.name for path in tmp_path.iterdir()] == ["photo.jpg"]


def test_writers_that_are_killed_leave_no_half_results(tmp_path):
    """Ten processes write the same and are killed at once, some of them while they write."""
    store = Store.make(tmp_path)
    script = ("import sys, fourpost_batch as b; from fourpost_batch.unit import result_text\n"
              "text = result_text(sys.argv[2], {'code': 0, 'printed': 'x' * 3000000, 'files': {}, 'messages': []})\n"
              "print('ready', flush=True)\n"
              "while True: b.Store(sys.argv[1]).put(sys.argv[2], text)\n")
    writers = [subprocess.Popen([sys.executable, "-c", script, tmp_path, KEY], stdout=subprocess.PIPE,
                                env={**os.environ, "PYTHONPATH": str(SOURCE / "python")}) for _ in range(4)]
    for writer in writers:
        writer.stdout.readline()
    end = time.monotonic() + 10
    while not store.path(KEY).exists() and time.monotonic() < end:
        time.sleep(0.01)
    for _ in range(20):
        assert len(store.get(KEY)["printed"]) == 3000000
    for writer in writers:
        writer.send_signal(signal.SIGKILL)
        writer.wait()
        writer.stdout.close()
    assert len(store.get(KEY)["printed"]) == 3000000 and not store.damaged
    assert list(store.keys()) == [KEY]


def test_an_input_that_was_altered_in_the_folder_is_kept_anew(tmp_path):
    store = Store.make(tmp_path / "out")
    (tmp_path / "a").write_bytes(b"content")
    digest = file_hash(tmp_path / "a")
    store.add_file(tmp_path / "a", digest)
    store.file(digest).write_bytes(b"-------")
    store.add_file(tmp_path / "a", digest)
    assert store.file(digest).read_bytes() == b"content"


def test_an_input_that_changes_meanwhile_is_refused(tmp_path):
    store = Store.make(tmp_path / "out")
    file = tmp_path / "a"
    file.write_text("1")
    with pytest.raises(BatchError):
        store.add_file(file, "0" * 64)
    assert not list((tmp_path / "out/files").iterdir())
