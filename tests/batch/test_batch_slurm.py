# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same night on Slurm: run by tests/batch/slurm_node, which starts one."""

import os
import unittest

import test_batch_local
from batch_case import PROJECT


class OnSlurm(test_batch_local.Night):
    more = ("--profile", str(PROJECT / "examples/batch/slurm"))

    @classmethod
    def setUpClass(cls) -> None:
        if not os.environ.get("SLURM_CONF"):
            raise unittest.SkipTest("there is no Slurm; scripts/test-batch starts one")
        super().setUpClass()

    def test_the_jobs_were_slurms(self):
        self.assertIn("with external jobid", self.log)
        self.assertTrue(list((self.out / "logs").glob("*.log")))


if __name__ == "__main__":
    unittest.main()
