# SPDX-License-Identifier: MIT
class_name MenuPage
extends RefCounted
## A page of a menu: a title and at most seven items.

const MOST_ITEMS: int = 7

## As written in the source; it is translated when shown.
var title: String
var items: Array[MenuItem] = []
## The page to which "Back" leads; empty: this is the first one.
var parent: StringName


static func of(words: String, its_items: Array[MenuItem], back_to: StringName = &"") -> MenuPage:
	var page := MenuPage.new()
	page.title = words
	page.items = its_items
	page.parent = back_to
	if its_items.size() > MOST_ITEMS:
		push_error("A menu's page has room for %d items." % MOST_ITEMS)
	return page


## Items that show something at their right need the page's whole width.
func get_columns() -> int:
	for item in items:
		if item.kind == MenuItem.Kind.TOGGLE or item.kind == MenuItem.Kind.CHOICE:
			return 1
	return 2 if items.size() > 4 else 1
