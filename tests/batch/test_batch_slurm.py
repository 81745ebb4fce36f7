# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same night on Slurm: run by tests/batch/slurm_node, which starts one."""

import os
import re
import unittest

import test_batch_local
from batch_case import PROJECT


class OnSlurm(test_batch_local.Night):
    more = ("--profile", str(PROJECT / "examples/batch/slurm"))
    settings = ("per_job=10",)

    @classmethod
    def setUpClass(cls) -> None:
        if not os.environ.get("SLURM_CONF"):
            raise unittest.SkipTest("there is no Slurm; scripts/test-batch starts one")
        super().setUpClass()

    def test_the_jobs_were_slurms(self):
        self.assertIn("with external jobid", self.log)
        self.assertTrue(list((self.out / "logs").glob("*.log")))

    def test_another_attempt_is_another_job(self):
        """It asks for more memory than the first, so that a part which the system killed has room."""
        asked = [int(mb) for mb in re.findall(r"mem_mb=(\d+)", self.log)]
        self.assertGreater(max(asked), 8000, "twice the first limit of the part that was killed")


if __name__ == "__main__":
    unittest.main()
