/* rsh_interface.h - rsh.h as data: structs with the offsets of their members, constants, functions.
 *
 * For bindings, which make their declarations of it, or check them; C and C++ programs need it
 * not. It is made from the headers when the library is compiled, and is what that library was
 * compiled with. An offset that a compiler has chosen is never written down by hand.
 */
#ifndef RSH_INTERFACE_H
#define RSH_INTERFACE_H

#include <rsh/rsh.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What a value is made of; with the size of an element, all that a binding must know to pass it. */
enum {
    RSH_KIND_VOID = 0,     /* nothing: the result of some functions                          */
    RSH_KIND_UNSIGNED = 1, /* unsigned integer                                               */
    RSH_KIND_SIGNED = 2,   /* signed integer                                                 */
    RSH_KIND_FLOAT = 3,    /* IEEE float; rsh_float4 is four of them                         */
    RSH_KIND_TEXT = 4,     /* char; an array of them ends with 0                             */
    RSH_KIND_POINTER = 5,  /* any pointer: to data, OpenCL's and rsh's handles, callbacks    */
    RSH_KIND_STRUCT = 6    /* a struct of rsh; `type` is its name                            */
};

/* A member of a struct, a parameter of a function, or its result. */
typedef struct rsh_field_info {
    const char* name; /* "struct_size"; of a result ""                                      */
    const char* type; /* of an element, as in the header: "cl_uint", "const rsh_scene*"     */
    size_t offset;    /* bytes from the front of the struct; else 0                         */
    size_t size;      /* bytes, of an array all of it                                       */
    cl_uint count;    /* elements of size / count bytes; 1, or more for arrays and vectors; of void 0 */
    cl_uint kind;     /* of an element: RSH_KIND_...                                        */
} rsh_field_info;

typedef struct rsh_struct_info {
    const char* name;
    size_t size;  /* bytes, with padding at the end                                         */
    size_t align; /* bytes                                                                  */
    const rsh_field_info* fields; /* in order                                               */
    size_t field_count;
} rsh_struct_info;

/* An enumerator, or a macro that is an integer. */
typedef struct rsh_constant_info {
    const char* name;
    cl_long value;
} rsh_constant_info;

/* A function, or the type of a callback. */
typedef struct rsh_function_info {
    const char* name;
    rsh_field_info result;
    const rsh_field_info* parameters;
    size_t parameter_count;
} rsh_function_info;

typedef struct rsh_interface {
    size_t struct_size; /* sizeof the struct in the library; it grows only at the end           */
    const rsh_struct_info* structs; /* as in the headers, each behind those that it is made of  */
    size_t struct_count;
    const rsh_constant_info* constants;
    size_t constant_count;
    const rsh_function_info* functions;
    size_t function_count;
    const rsh_function_info* callbacks; /* rsh_log, rsh_progress                                */
    size_t callback_count;
} rsh_interface;

/* The interface of the library at run time. Never NULL; static storage. The other structs here
 * never change size. */
RSH_API const rsh_interface* rsh_describe_interface(void);

#ifdef __cplusplus
}
#endif

#endif /* RSH_INTERFACE_H */
