// port: the stream type of an entry point, one packed record a word.
//   port<T>   hls::stream<port_word<T>> for Vitis HLS and Bambu, ac_channel for Catapult, stream in simulation, where it takes as
//             many words as a bench writes before it lets an entry point run.
//   Kernels use read() and write() alone, which all of them have.
#pragma once
#include "hls/core/packed.hpp"

#if defined(RELIEVO_AP_FIXED)
#include <hls_stream.h>
#elif defined(RELIEVO_AC_FIXED)
#include <ac_channel.h>
#else
#include "hls/core/stream.hpp"
#endif

namespace relievo {
namespace hls {

#if defined(RELIEVO_AP_FIXED)
template <class T>
using port = ::hls::stream<port_word<T>>;
#elif defined(RELIEVO_AC_FIXED)
template <class T>
using port = ac_channel<port_word<T>>;
#else
template <class T>
using port = stream<port_word<T>, 4096>;
#endif

}  // namespace hls
}  // namespace relievo
