# SPDX-License-Identifier: GPL-3.0-or-later
import os
from pathlib import Path

import pytest
import roomatlas

WORLDS = Path(os.environ.get("ROOMATLAS_WORLDS",
                             Path(__file__).resolve().parents[2] / "data" / "worlds"))


@pytest.fixture(scope="session")
def world() -> Path:
    return WORLDS / "two_rooms.geojson"


@pytest.fixture(scope="session")
def mission(world, tmp_path_factory) -> roomatlas.Mission:
    return roomatlas.simulate(world, tmp_path_factory.mktemp("mission"), odometry="typical")


@pytest.fixture(scope="session")
def building(mission) -> roomatlas.Building:
    return roomatlas.build(mission.log)
