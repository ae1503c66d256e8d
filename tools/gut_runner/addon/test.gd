# SPDX-License-Identifier: MIT
class_name GutTest
extends "parts/layer_waits.gd"
## Base class of all test scripts.
##
## A test is a method whose name begins with test_, without parameter or with one that defaults to
## use_parameters([...]). Inner classes whose names begin with Test and which extend GutTest are
## scripts of their own.
