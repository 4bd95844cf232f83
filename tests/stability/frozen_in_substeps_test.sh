#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# frozen_in_substeps_test.sh BUILD: liquid freezes beside the border of ranks while solids take substeps. The
# densities beside the new solid must not depend on the ranks.
exec bash "$(dirname "$0")/random_scenes_test.sh" "$1" 1 53170
