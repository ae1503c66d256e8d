# SPDX-License-Identifier: MIT
class_name MilkyWay
extends RefCounted
## The Milky Way panorama that comes with the addon, and its place on the radiometric scale.

const FILE: String = "res://addons/blackhole_sky/data/milky_way.exr"
## Luminance at exposure 0 of a texel of value 1 (see tools/milky_way/README.md).
const LUMINANCE: float = 0.147
