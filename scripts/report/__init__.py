# SPDX-License-Identifier: LGPL-2.1-or-later
"""The HTML report: data (what a results directory holds), figures, the 3D view and the page."""
