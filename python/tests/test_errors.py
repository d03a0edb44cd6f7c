# SPDX-License-Identifier: GPL-3.0-or-later
import os
import signal
import threading
import time

import pytest
import roomatlas


def test_what_is_wrong_is_raised_and_named(tmp_path):
    missing = tmp_path / "missing.clf"
    with pytest.raises(roomatlas.InputError, match="missing.clf"):
        roomatlas.build(missing)
    with pytest.raises(roomatlas.InputError, match="missing.gpkg"):
        roomatlas.open(tmp_path / "missing.gpkg")
    (tmp_path / "no_store.gpkg").write_text("no store")
    with pytest.raises(roomatlas.InputError, match="no_store.gpkg"):
        roomatlas.open(tmp_path / "no_store.gpkg")
    for error in (roomatlas.InputError, roomatlas.UsageError, roomatlas.NotEnoughError):
        assert issubclass(error, roomatlas.Error)


def test_a_log_without_readings_is_not_enough(tmp_path):
    log = tmp_path / "log.clf"
    log.write_text("ODOM 0 0 0 0 0 0 1.0 host 1.0\n" * 3)
    store = tmp_path / "building.gpkg"
    with pytest.raises(roomatlas.NotEnoughError):
        roomatlas.build(log, store)
    assert [file.name for file in tmp_path.iterdir()] == ["log.clf"]


def test_wrong_parameters_are_named(mission):
    with pytest.raises(roomatlas.UsageError, match="no-such-thing"):
        roomatlas.build(mission.log, no_such_thing=1)
    with pytest.raises(roomatlas.UsageError, match="plan"):
        roomatlas.build(mission.log, plan="painted")
    with pytest.raises(roomatlas.UsageError, match="cell"):
        roomatlas.build(mission.log, cell=[1])
    with pytest.raises(roomatlas.UsageError, match="quiet"):
        roomatlas.build(mission.log, quiet=True)
    with pytest.raises(roomatlas.UsageError, match="jobs"):
        roomatlas.build(mission.log, jobs=-1)
    with pytest.raises(roomatlas.UsageError, match="resolution_m"):
        roomatlas.build(mission.log, resolution_m=0.05)


def test_the_log_is_never_overwritten(mission):
    before = mission.log.read_bytes()
    with pytest.raises(roomatlas.UsageError, match="log itself"):
        roomatlas.build(mission.log, mission.log)
    assert mission.log.read_bytes() == before


def test_progress_is_told(mission):
    told = []
    roomatlas.build(mission.log, progress=lambda stage, share: told.append((stage, share)))
    assert told
    assert all(share is None or 0.0 <= share <= 1.0 for _, share in told)


def test_what_progress_raises_comes_back(mission, tmp_path):
    class Enough(Exception):
        pass

    def stop(stage, share):
        raise Enough(stage)

    with pytest.raises(Enough):
        roomatlas.build(mission.log, tmp_path / "building.gpkg", progress=stop)
    assert not list(tmp_path.iterdir())


def test_control_c_stops_the_work(mission, tmp_path):
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background jobs ignore it

    def interrupt(stage, share):
        os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        roomatlas.build(mission.log, tmp_path / "building.gpkg", progress=interrupt)
    assert not list(tmp_path.iterdir())


def test_other_threads_of_python_go_on_meanwhile(mission):
    counted, done = 0, threading.Event()

    def count():
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    other = threading.Thread(target=count)
    other.start()
    before = counted
    told = []
    roomatlas.build(mission.log, progress=lambda *_: told.append(counted))
    done.set()
    other.join()
    assert counted > before
    assert len(set(told)) > 1, "the other thread stood still between two calls"
