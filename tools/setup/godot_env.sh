# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# Sourced before a program of a private copy starts (Godot; Monado, which must draw with the same driver); $root and
# $libraries are set above by the set-up.
#
# Which graphics drivers? The copy runs on its own C library, so it takes its own Mesa, which holds the drivers for
# AMD, Intel, Nouveau and virtual cards as well as the software ones. Pointing at that Mesa forces nothing: with a
# card (/dev/dri/render*, or /dev/dxg under WSL) its drivers are listed first and Godot picks the card; the software
# driver is the last resort. NVIDIA's own driver is not part of Mesa: where the system has it, its description files
# join the list, and the system's library is found through the loader's cache. What the user has set stays.

: "${root:?}" "${libraries:?}"

blackhole_sky_vulkan=
blackhole_sky_egl=$root/usr/share/glvnd/egl_vendor.d/50_mesa.json
for file in /etc/vulkan/icd.d/nvidia_icd*.json /usr/share/vulkan/icd.d/nvidia_icd*.json; do
	if [ -e "$file" ] && [ -e /dev/nvidiactl ]; then
		blackhole_sky_vulkan=$blackhole_sky_vulkan$file:
	fi
done
for file in /etc/glvnd/egl_vendor.d/*nvidia.json /usr/share/glvnd/egl_vendor.d/*nvidia.json; do
	if [ -e "$file" ] && [ -e /dev/nvidiactl ]; then
		blackhole_sky_egl=$file:$blackhole_sky_egl
	fi
done
for device in /dev/dri/renderD* /dev/dxg; do
	if [ -e "$device" ]; then
		for file in "$root"/usr/share/vulkan/icd.d/*.json; do
			case $file in
				*/lvp_icd*) ;;
				*) blackhole_sky_vulkan=$blackhole_sky_vulkan$file: ;;
			esac
		done
		break
	fi
done
for file in "$root"/usr/share/vulkan/icd.d/lvp_icd*.json; do
	blackhole_sky_vulkan=$blackhole_sky_vulkan$file
	break
done

export VK_DRIVER_FILES="${VK_DRIVER_FILES:-$blackhole_sky_vulkan}"
export __EGL_VENDOR_LIBRARY_FILENAMES="${__EGL_VENDOR_LIBRARY_FILENAMES:-$blackhole_sky_egl}"
export LIBGL_DRIVERS_PATH="${LIBGL_DRIVERS_PATH:-$libraries/dri}"
export XKB_CONFIG_ROOT="${XKB_CONFIG_ROOT:-$root/usr/share/X11/xkb}"
export FONTCONFIG_PATH="${FONTCONFIG_PATH:-$root/etc/fonts}"
unset blackhole_sky_vulkan blackhole_sky_egl file device
