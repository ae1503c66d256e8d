# SPDX-License-Identifier: MIT
# Shading languages know single-precision literals only; C++ wants them marked. Run as
#   cmake -DINPUT=x.gdshaderinc -DOUTPUT=x.inc -P shader_to_cpp.cmake
file(READ "${INPUT}" _source)
# 1.0, 1.0e-6, 0.5: digits on both sides of the dot, as the shaders write them.
string(REGEX REPLACE "([0-9]+\\.[0-9]+(e[-+]?[0-9]+)?)" "\\1F" _source "${_source}")
file(WRITE "${OUTPUT}" "${_source}")
