# SPDX-License-Identifier: MIT
class_name EyeCapture
extends CompositorEffect
## Copies what each eye of a headset is shown: the engine draws it into the runtime's own pictures,
## so that the viewport's texture stays black. For the renderers Mobile and Forward+.
##
## take() does it all; or put it into a Compositor of the camera, request() and wait for `taken`.

## Both pictures, left first, linear light as the renderer has it.
signal taken(pictures: Array[Image])

const _SOURCE: String = """#version 450
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform sampler2D source;
layout(rgba32f, set = 0, binding = 1) uniform writeonly image2D target;
layout(push_constant) uniform Light { float scale; float a; float b; float c; } light;
void main() {
	ivec2 at = ivec2(gl_GlobalInvocationID.xy);
	if (all(lessThan(at, imageSize(target)))) {
		vec4 seen = texelFetch(source, at, 0);
		imageStore(target, at, vec4(seen.rgb * light.scale, seen.a));
	}
}
"""

var _wanted: bool = false
var _pictures: Dictionary[int, Image] = {}
var _views: int = 0
var _device: RenderingDevice
var _shader: RID
var _pipeline: RID
var _sampler: RID


func _init() -> void:
	effect_callback_type = EFFECT_CALLBACK_TYPE_POST_TRANSPARENT
	access_resolved_color = true
	_device = RenderingServer.get_rendering_device()


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE and _device != null:
		for made: RID in [_pipeline, _shader, _sampler]:
			if made.is_valid():
				_device.free_rid(made)


## The next frame is copied.
func request() -> void:
	_pictures.clear()
	_wanted = true


## What both eyes of `head` are shown, left first; nothing when it does not come within `seconds`.
static func take(head: XRCamera3D, seconds: float) -> Array[Image]:
	var capture := new()
	var pictures: Array[Image] = []
	capture.taken.connect(func(both: Array[Image]) -> void: pictures.assign(both))
	var before := head.compositor
	head.compositor = Compositor.new()
	head.compositor.compositor_effects = [capture]
	capture.request()
	await Waiting.until(head.get_tree(), func() -> bool: return not pictures.is_empty(), seconds)
	head.compositor = before
	return pictures


## Works on the rendering thread.
func _render_callback(_type: int, data: RenderData) -> void:
	var buffers := data.get_render_scene_buffers() as RenderSceneBuffersRD
	if not _wanted or buffers == null or buffers.get_view_count() < 2:
		return
	_wanted = false
	_views = buffers.get_view_count()
	_make_pipeline()
	for view in _views:
		_copy(buffers.get_color_layer(view), view)


func _make_pipeline() -> void:
	if _pipeline.is_valid():
		return
	var source := RDShaderSource.new()
	source.language = RenderingDevice.SHADER_LANGUAGE_GLSL
	source.source_compute = _SOURCE
	_shader = _device.shader_create_from_spirv(_device.shader_compile_spirv_from_source(source))
	_pipeline = _device.compute_pipeline_create(_shader)
	_sampler = _device.sampler_create(RDSamplerState.new())


func _copy(layer: RID, view: int) -> void:
	var format := _device.texture_get_format(layer)
	var size := Vector2i(format.width, format.height)
	var wanted := RDTextureFormat.new()
	wanted.width = size.x
	wanted.height = size.y
	wanted.format = RenderingDevice.DATA_FORMAT_R32G32B32A32_SFLOAT
	wanted.usage_bits = (
		RenderingDevice.TEXTURE_USAGE_STORAGE_BIT | RenderingDevice.TEXTURE_USAGE_CAN_COPY_FROM_BIT
	)
	var copy := _device.texture_create(wanted, RDTextureView.new())
	var uniforms: Array[RDUniform] = [RDUniform.new(), RDUniform.new()]
	uniforms[0].uniform_type = RenderingDevice.UNIFORM_TYPE_SAMPLER_WITH_TEXTURE
	uniforms[0].add_id(_sampler)
	uniforms[0].add_id(layer)
	uniforms[1].uniform_type = RenderingDevice.UNIFORM_TYPE_IMAGE
	uniforms[1].binding = 1
	uniforms[1].add_id(copy)
	var bound := _device.uniform_set_create(uniforms, _shader, 0)
	var list := _device.compute_list_begin()
	_device.compute_list_bind_compute_pipeline(list, _pipeline)
	_device.compute_list_bind_uniform_set(list, bound, 0)
	# Mobile keeps half the light in ten bits, so that twice white has room.
	var halved := format.format == RenderingDevice.DATA_FORMAT_A2B10G10R10_UNORM_PACK32
	var scale := PackedFloat32Array([2.0 if halved else 1.0, 0.0, 0.0, 0.0]).to_byte_array()
	_device.compute_list_set_push_constant(list, scale, scale.size())
	_device.compute_list_dispatch(list, ceili(size.x / 8.0), ceili(size.y / 8.0), 1)
	_device.compute_list_end()
	_device.texture_get_data_async(copy, 0, _on_copied.bind(view, size, copy, bound))


func _on_copied(data: PackedByteArray, view: int, size: Vector2i, copy: RID, bound: RID) -> void:
	if _device.uniform_set_is_valid(bound):
		_device.free_rid(bound)
	_device.free_rid(copy)
	_pictures[view] = Image.create_from_data(size.x, size.y, false, Image.FORMAT_RGBAF, data)
	if _pictures.size() == _views:
		var pictures: Array[Image] = []
		for each in _views:
			pictures.append(_pictures[each])
		taken.emit.call_deferred(pictures)
