# SPDX-License-Identifier: MIT
class_name DesktopScreens
extends RefCounted
## Every page and every station of the desktop scene, by name, to be looked at one after the other.

## Enough for every way to a station.
const LONGEST_WAY: float = 40.0

var _scene: DesktopScene
var _shows: Dictionary[String, Callable] = {}
var _tour: Tour


func _init(scene: DesktopScene) -> void:
	_scene = scene
	_shows["title"] = _scene.show_title
	_shows["menu"] = func() -> void: _menus().toggle_menu()
	_shows["controls"] = _show_page.bind(MainMenu.CONTROLS)
	for page in SettingsScreen.TITLES.size():
		_shows["settings_%d" % page] = _show_settings.bind(page)
	for card in _cards().card_set.cards.size():
		_shows["card_%02d" % card] = _show_card.bind(card)
	_shows["credits"] = _show_page.bind(MainMenu.CREDITS)
	_shows["photo"] = func() -> void: (_scene.get_node("%PhotoMode") as PhotoMode).open()
	for page in 5:
		_shows["panel_%d" % page] = _show_panel.bind(page)
	_shows["flight"] = func() -> void: pass
	_shows["ride"] = func() -> void: _rides().start(RideDirector.Kind.FROM_REST)
	_shows["map"] = func() -> void: (_scene.get_node("%Map") as MapWindow).open()
	_add_tour()


func get_names() -> PackedStringArray:
	return PackedStringArray(_shows.keys())


## Opens the page of a name, of a scene where none is open.
func show(name: String) -> void:
	_shows[name].call()


## Closes whatever is open.
func clear() -> void:
	var guide: TourGuide = _scene.get_node("%TourGuide")
	guide.leave()
	guide.automatic = true
	_rides().leave()
	for name: String in ["%Help", "%Settings", "%Cards", "%Credits", "%PhotoMode"]:
		(_scene.get_node(name) as MenuScreen).close()
	(_scene.get_node("%MainMenu") as MainMenu).hide()
	(_scene.get_node("%Panel") as SkyPanel).hide()
	(_scene.get_node("%Map") as MapWindow).close()


func _add_tour() -> void:
	var guide: TourGuide = _scene.get_node("%TourGuide")
	_tour = TourFile.read(guide.tour_file).tour
	for station in _tour.stations.size():
		for caption in _tour.stations[station].captions.size():
			_shows["tour_%02d_%d" % [station, caption]] = _show_station.bind(station, caption)


func _menus() -> MenuDirector:
	return _scene.get_node("Menus")


func _cards() -> CardScreen:
	return _scene.get_node("%Cards")


func _rides() -> RideDirector:
	return _scene.get_node("Rides")


func _show_page(item: StringName) -> void:
	_menus().toggle_page(item)


func _show_settings(page: int) -> void:
	_show_page(MainMenu.SETTINGS)
	(_scene.get_node("%Settings") as SettingsScreen).turn_to(page)


func _show_card(card: int) -> void:
	_show_page(MainMenu.CARDS)
	_cards().show_card(card)


func _show_panel(page: int) -> void:
	var panel: SkyPanel = _scene.get_node("%Panel")
	panel.open()
	(panel.get_node("%Tabs") as TabContainer).current_tab = page


func _show_station(station: int, caption: int) -> void:
	var guide: TourGuide = _scene.get_node("%TourGuide")
	guide.automatic = false
	guide.start(_tour, station)
	for i in caption + 1:
		if i > 0:
			guide.next()
		for step in 20:
			guide.advance(LONGEST_WAY / 20.0)
