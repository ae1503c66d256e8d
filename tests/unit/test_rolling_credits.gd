# SPDX-License-Identifier: MIT
extends GutTest
## In the headset the credits roll entry by entry and end by themselves or when asked to.

var _credits: RollingCredits
var _board: VisitSign


func before_each() -> void:
	var head := Node3D.new()
	_board = VisitSign.new()
	_board.head = head
	_credits = RollingCredits.new()
	_credits.board = _board
	for node: Node in [head, _board, _credits]:
		add_child_autofree(node)
	_credits.set_process(false)


func test_every_entry_is_shown_for_long_enough() -> void:
	_credits.toggle()
	for entry in CreditsText.entries():
		assert_true(_board.visible)
		assert_string_contains(_board.get_words(), entry.text)
		assert_gt(RollingCredits.reading_time(entry), 2.5)
		_credits._process(RollingCredits.reading_time(entry) - 0.1)
		assert_string_contains(_board.get_words(), entry.text)
		_credits._process(0.2)
	assert_false(_credits.is_on())


func test_they_end_when_asked_again() -> void:
	_credits.toggle()
	assert_true(_credits.is_on())
	_credits.toggle()
	assert_false(_credits.is_on())
	assert_false(_board.visible)
