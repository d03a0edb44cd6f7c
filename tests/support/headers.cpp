// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled for its precompiled headers alone, which all tests use.
