// SPDX-License-Identifier: MIT
// The engine's C functions that the provider calls, loaded once by name when the library is opened.
#pragma once

#include <gdextension_interface.h>

// X(type, name): the function pointer's type in gdextension_interface.h and its documented name.
#define GODOT_PROVIDER_FUNCTIONS(X)                                                                          \
	X(GDExtensionInterfaceGetGodotVersion2, get_godot_version2)                                              \
	X(GDExtensionInterfacePrintErrorWithMessage, print_error_with_message)                                   \
	X(GDExtensionInterfacePrintWarningWithMessage, print_warning_with_message)                               \
	X(GDExtensionInterfaceVariantNewCopy, variant_new_copy)                                                  \
	X(GDExtensionInterfaceVariantNewNil, variant_new_nil)                                                    \
	X(GDExtensionInterfaceVariantDestroy, variant_destroy)                                                   \
	X(GDExtensionInterfaceVariantCall, variant_call)                                                         \
	X(GDExtensionInterfaceVariantEvaluate, variant_evaluate)                                                 \
	X(GDExtensionInterfaceVariantHash, variant_hash)                                                         \
	X(GDExtensionInterfaceVariantBooleanize, variant_booleanize)                                             \
	X(GDExtensionInterfaceVariantDuplicate, variant_duplicate)                                               \
	X(GDExtensionInterfaceVariantStringify, variant_stringify)                                               \
	X(GDExtensionInterfaceVariantGetType, variant_get_type)                                                  \
	X(GDExtensionInterfaceVariantGetTypeName, variant_get_type_name)                                         \
	X(GDExtensionInterfaceVariantGetObjectInstanceId, variant_get_object_instance_id)                        \
	X(GDExtensionInterfaceVariantCanConvert, variant_can_convert)                                            \
	X(GDExtensionInterfaceVariantCanConvertStrict, variant_can_convert_strict)                               \
	X(GDExtensionInterfaceGetVariantFromTypeConstructor, get_variant_from_type_constructor)                  \
	X(GDExtensionInterfaceGetVariantToTypeConstructor, get_variant_to_type_constructor)                      \
	X(GDExtensionInterfaceVariantGetPtrOperatorEvaluator, variant_get_ptr_operator_evaluator)                \
	X(GDExtensionInterfaceVariantGetPtrBuiltinMethod, variant_get_ptr_builtin_method)                        \
	X(GDExtensionInterfaceVariantGetPtrConstructor, variant_get_ptr_constructor)                             \
	X(GDExtensionInterfaceVariantGetPtrDestructor, variant_get_ptr_destructor)                               \
	X(GDExtensionInterfaceVariantGetPtrUtilityFunction, variant_get_ptr_utility_function)                    \
	X(GDExtensionInterfaceStringNewWithLatin1Chars, string_new_with_latin1_chars)                            \
	X(GDExtensionInterfaceStringNewWithUtf8CharsAndLen, string_new_with_utf8_chars_and_len)                  \
	X(GDExtensionInterfaceStringNewWithUtf32Chars, string_new_with_utf32_chars)                              \
	X(GDExtensionInterfaceStringNewWithWideChars, string_new_with_wide_chars)                                \
	X(GDExtensionInterfaceStringToLatin1Chars, string_to_latin1_chars)                                       \
	X(GDExtensionInterfaceStringToUtf8Chars, string_to_utf8_chars)                                           \
	X(GDExtensionInterfaceStringOperatorIndexConst, string_operator_index_const)                             \
	X(GDExtensionInterfaceStringOperatorPlusEqString, string_operator_plus_eq_string)                        \
	X(GDExtensionInterfaceStringNameNewWithLatin1Chars, string_name_new_with_latin1_chars)                   \
	X(GDExtensionInterfacePackedByteArrayOperatorIndex, packed_byte_array_operator_index)                    \
	X(GDExtensionInterfacePackedByteArrayOperatorIndexConst, packed_byte_array_operator_index_const)         \
	X(GDExtensionInterfacePackedInt32ArrayOperatorIndex, packed_int32_array_operator_index)                  \
	X(GDExtensionInterfacePackedInt32ArrayOperatorIndexConst, packed_int32_array_operator_index_const)       \
	X(GDExtensionInterfacePackedInt64ArrayOperatorIndex, packed_int64_array_operator_index)                  \
	X(GDExtensionInterfacePackedInt64ArrayOperatorIndexConst, packed_int64_array_operator_index_const)       \
	X(GDExtensionInterfacePackedFloat32ArrayOperatorIndex, packed_float32_array_operator_index)              \
	X(GDExtensionInterfacePackedFloat32ArrayOperatorIndexConst, packed_float32_array_operator_index_const)   \
	X(GDExtensionInterfacePackedFloat64ArrayOperatorIndex, packed_float64_array_operator_index)              \
	X(GDExtensionInterfacePackedFloat64ArrayOperatorIndexConst, packed_float64_array_operator_index_const)   \
	X(GDExtensionInterfacePackedStringArrayOperatorIndex, packed_string_array_operator_index)                \
	X(GDExtensionInterfacePackedStringArrayOperatorIndexConst, packed_string_array_operator_index_const)     \
	X(GDExtensionInterfacePackedVector2ArrayOperatorIndex, packed_vector2_array_operator_index)              \
	X(GDExtensionInterfacePackedVector2ArrayOperatorIndexConst, packed_vector2_array_operator_index_const)   \
	X(GDExtensionInterfacePackedVector3ArrayOperatorIndex, packed_vector3_array_operator_index)              \
	X(GDExtensionInterfacePackedVector3ArrayOperatorIndexConst, packed_vector3_array_operator_index_const)   \
	X(GDExtensionInterfacePackedVector4ArrayOperatorIndex, packed_vector4_array_operator_index)              \
	X(GDExtensionInterfacePackedVector4ArrayOperatorIndexConst, packed_vector4_array_operator_index_const)   \
	X(GDExtensionInterfacePackedColorArrayOperatorIndex, packed_color_array_operator_index)                  \
	X(GDExtensionInterfacePackedColorArrayOperatorIndexConst, packed_color_array_operator_index_const)       \
	X(GDExtensionInterfaceArrayOperatorIndex, array_operator_index)                                          \
	X(GDExtensionInterfaceArrayOperatorIndexConst, array_operator_index_const)                               \
	X(GDExtensionInterfaceArraySetTyped, array_set_typed)                                                    \
	X(GDExtensionInterfaceDictionaryOperatorIndex, dictionary_operator_index)                                \
	X(GDExtensionInterfaceDictionaryOperatorIndexConst, dictionary_operator_index_const)                     \
	X(GDExtensionInterfaceObjectMethodBindCall, object_method_bind_call)                                     \
	X(GDExtensionInterfaceObjectMethodBindPtrcall, object_method_bind_ptrcall)                               \
	X(GDExtensionInterfaceObjectDestroy, object_destroy)                                                     \
	X(GDExtensionInterfaceGlobalGetSingleton, global_get_singleton)                                          \
	X(GDExtensionInterfaceObjectGetInstanceBinding, object_get_instance_binding)                             \
	X(GDExtensionInterfaceObjectSetInstanceBinding, object_set_instance_binding)                             \
	X(GDExtensionInterfaceObjectFreeInstanceBinding, object_free_instance_binding)                           \
	X(GDExtensionInterfaceObjectSetInstance, object_set_instance)                                            \
	X(GDExtensionInterfaceObjectGetClassName, object_get_class_name)                                         \
	X(GDExtensionInterfaceObjectGetInstanceFromId, object_get_instance_from_id)                              \
	X(GDExtensionInterfaceObjectGetInstanceId, object_get_instance_id)                                       \
	X(GDExtensionInterfaceRefSetObject, ref_set_object)                                                      \
	X(GDExtensionInterfaceCallableCustomCreate2, callable_custom_create2)                                    \
	X(GDExtensionInterfaceClassdbConstructObject2, classdb_construct_object2)                                \
	X(GDExtensionInterfaceClassdbGetMethodBind, classdb_get_method_bind)                                     \
	X(GDExtensionInterfaceClassdbRegisterExtensionClass5, classdb_register_extension_class5)                 \
	X(GDExtensionInterfaceClassdbRegisterExtensionClassMethod, classdb_register_extension_class_method)      \
	X(GDExtensionInterfaceClassdbRegisterExtensionClassIntegerConstant,                                      \
			classdb_register_extension_class_integer_constant)                                               \
	X(GDExtensionInterfaceClassdbRegisterExtensionClassPropertyIndexed,                                      \
			classdb_register_extension_class_property_indexed)                                               \
	X(GDExtensionInterfaceClassdbRegisterExtensionClassPropertyGroup,                                        \
			classdb_register_extension_class_property_group)                                                 \
	X(GDExtensionInterfaceClassdbRegisterExtensionClassPropertySubgroup,                                     \
			classdb_register_extension_class_property_subgroup)                                              \
	X(GDExtensionInterfaceClassdbRegisterExtensionClassSignal, classdb_register_extension_class_signal)      \
	X(GDExtensionInterfaceClassdbUnregisterExtensionClass, classdb_unregister_extension_class)               \
	X(GDExtensionsInterfaceEditorHelpLoadXmlFromUtf8CharsAndLen, editor_help_load_xml_from_utf8_chars_and_len)

namespace godot::internal {

// One pointer per function above.
struct Interface {
#define GODOT_PROVIDER_MEMBER(type, name) type name = nullptr;
	GODOT_PROVIDER_FUNCTIONS(GODOT_PROVIDER_MEMBER)
#undef GODOT_PROVIDER_MEMBER
};

// Filled by load_interface(); valid from the library's entry function on.
extern Interface api;

// The library's handle; also the token under which our wrappers are kept with the engine's objects.
extern GDExtensionClassLibraryPtr library;

// Looks up every function; false, with the missing name on stderr, when the engine lacks one.
bool load_interface(GDExtensionInterfaceGetProcAddress get_proc_address, GDExtensionClassLibraryPtr handle);

} // namespace godot::internal
