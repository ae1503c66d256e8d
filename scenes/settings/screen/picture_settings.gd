# SPDX-License-Identifier: MIT
class_name PictureSettings
extends SettingsPage
## The page of the picture, which also says what draws it and how another renderer is chosen.

const RENDERERS: Dictionary[String, String] = {
	"forward_plus": "Forward+", "mobile": "Mobile", "gl_compatibility": "Compatibility"
}

var _renderer: Label


func _init(settings: UserSettings) -> void:
	super(SettingList.PICTURE, settings)
	_renderer = add_words("")


func _notification(what: int) -> void:
	if what == NOTIFICATION_TRANSLATION_CHANGED or what == NOTIFICATION_READY:
		_renderer.text = renderer_words()


## Which renderer draws on which card, and how to have another.
static func renderer_words() -> String:
	var method := RenderingServer.get_current_rendering_method()
	var card := RenderingServer.get_video_adapter_name()
	return (
		"\n"
		+ _translated("Renderer: %s, on %s.") % [RENDERERS.get(method, method), card]
		+ " "
		+ _translated("For another one start with --rendering-method and %s.") % _others(method)
	)


static func _others(method: String) -> String:
	var names := PackedStringArray()
	for renderer in RENDERERS:
		if renderer != method:
			names.append(renderer)
	return _translated("%s or %s") % [names[0], names[1]]


static func _translated(text: String) -> String:
	return TranslationServer.translate(text)
