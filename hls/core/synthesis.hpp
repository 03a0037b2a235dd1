// synthesis: which tool reads this, asked once and nowhere else.
//   RELIEVO_SYNTHESIS   defined when any HLS tool compiles, and by scripts/lint.sh; kernels ask this one alone
//   RELIEVO_AP_FIXED    words are ap_fixed and ap_uint (Vitis HLS, Bambu), RELIEVO_AC_FIXED: ac_fixed and ac_int (Catapult);
//                       either can be given to a host compiler too, to hold that library against fixed (scripts/portability.sh)
#pragma once

#if (defined(__SYNTHESIS__) || defined(__BAMBU__)) && !defined(RELIEVO_SYNTHESIS)
#define RELIEVO_SYNTHESIS
#endif

#if defined(RELIEVO_SYNTHESIS) && !defined(RELIEVO_LINT) && !defined(RELIEVO_AP_FIXED) && !defined(RELIEVO_AC_FIXED)
#if defined(__CCS__) || defined(CATAPULT) || defined(CCS_SCVERIFY)
#define RELIEVO_AC_FIXED
#else
#define RELIEVO_AP_FIXED
#endif
#endif

// The widest port, the engine's registers, is beyond the 1024 bits that ap_uint has unless told otherwise.
#if defined(RELIEVO_AP_FIXED) && !defined(AP_INT_MAX_W)
#define AP_INT_MAX_W 4096
#endif
