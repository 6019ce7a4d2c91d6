"""Processes that compute for pages."""

from __future__ import annotations

import asyncio
import time

import pytest

from chaplygin.server.workers import Message, Pool

pytestmark = pytest.mark.server


def test_a_computation_that_takes_too_long_is_ended_and_the_next_one_has_its_place() -> None:
    async def answers() -> tuple[list[Message], int, int]:
        # a worker that sleeps answers nothing
        pool = Pool(time.sleep, 1, longest=0.5)  # type: ignore[arg-type]
        try:
            parts = [part async for part in pool.ask(60.0)]
            before = len(pool._all)
            again = [part async for part in pool.ask(60.0)]
            assert again[-1] == parts[-1]
            await asyncio.sleep(2.0)
            return parts, before, len(pool._all)
        finally:
            pool.close()

    parts, before, after = asyncio.run(answers())
    assert parts == [{"error": "it took longer than 0.5 s and was stopped"}]
    assert before == 1
    assert after == 0
