//! The operations of registers in the vector instructions of x86-64, by the same names for each set of instructions and each width.

#![allow(clippy::wildcard_imports, reason = "the names of instructions begin alike, and are many")]

/// Multiplication with addition where no instruction does both.
macro_rules! twice_rounded {
    ($enable:literal) => {
        /// `x·a + b`
        #[inline]
        #[target_feature(enable = $enable)]
        pub(crate) fn times_plus(x: Register, a: Register, b: Register) -> Register {
            add(mul(x, a), b)
        }

        /// `b − x·a`
        #[inline]
        #[target_feature(enable = $enable)]
        pub(crate) fn times_from(x: Register, a: Register, b: Register) -> Register {
            sub(b, mul(x, a))
        }
    };
}

/// Exchanges and signs sine and cosine by the number of quarter turns: [`sine::Bits::turn_back`].
macro_rules! turn_back {
    ($enable:literal, $to_bits:ident, $from_bits:ident, $splat:ident, $and:ident, $xor:ident, $add:ident, $sub:ident, $shift:ident) => {
        #[inline]
        #[target_feature(enable = $enable)]
        pub(crate) fn turn_back(turns: Register, sine: Register, cosine: Register) -> (Register, Register) {
            let (turns, s, c) = ($to_bits(turns), $to_bits(sine), $to_bits(cosine));
            let (one, two) = ($splat(1), $splat(2));
            let exchange = $sub($splat(0), $and(turns, one));
            let difference = $and($xor(s, c), exchange);
            let negative_sine = $shift::<62>($and(turns, two));
            let negative_cosine = $shift::<62>($and($add(turns, one), two));
            let sine = $xor($xor(s, difference), negative_sine);
            let cosine = $xor($xor(c, difference), negative_cosine);
            ($from_bits(sine), $from_bits(cosine))
        }
    };
}

pub(crate) mod sse2 {
    pub(crate) mod doubles {
        use core::arch::x86_64::*;
        pub(crate) use core::arch::x86_64::{
            __m128d as Register, _mm_add_pd as add, _mm_andnot_pd as andnot, _mm_div_pd as div,
            _mm_mul_pd as mul, _mm_set1_pd as splat, _mm_sub_pd as sub, _mm_xor_pd as xor,
        };

        twice_rounded!("sse2");
        turn_back!(
            "sse2",
            _mm_castpd_si128,
            _mm_castsi128_pd,
            _mm_set1_epi64x,
            _mm_and_si128,
            _mm_xor_si128,
            _mm_add_epi64,
            _mm_sub_epi64,
            _mm_slli_epi64
        );

        #[inline]
        #[target_feature(enable = "sse2")]
        pub(crate) fn interleave(a: Register, b: Register) -> [Register; 2] {
            [_mm_unpacklo_pd(a, b), _mm_unpackhi_pd(a, b)]
        }

        #[inline]
        #[target_feature(enable = "sse2")]
        pub(crate) fn all_le(a: Register, b: Register) -> bool {
            _mm_movemask_pd(_mm_cmple_pd(a, b)) == 0b11
        }

        #[inline]
        #[target_feature(enable = "sse2")]
        pub(crate) fn select_gt(a: Register, b: Register, x: Register, y: Register) -> Register {
            let mask = _mm_cmpgt_pd(a, b);
            _mm_or_pd(_mm_and_pd(mask, x), _mm_andnot_pd(mask, y))
        }
    }

    pub(crate) mod singles {
        use super::doubles;
        use core::arch::x86_64::*;
        pub(crate) use core::arch::x86_64::{
            __m128 as Register, _mm_add_ps as add, _mm_andnot_ps as andnot, _mm_div_ps as div,
            _mm_mul_ps as mul, _mm_set1_ps as splat, _mm_sub_ps as sub, _mm_xor_ps as xor,
        };

        twice_rounded!("sse2");

        #[inline]
        #[target_feature(enable = "sse2")]
        pub(crate) fn interleave(a: Register, b: Register) -> [Register; 2] {
            [_mm_unpacklo_ps(a, b), _mm_unpackhi_ps(a, b)]
        }

        #[inline]
        #[target_feature(enable = "sse2")]
        pub(crate) fn all_le(a: Register, b: Register) -> bool {
            _mm_movemask_ps(_mm_cmple_ps(a, b)) == 0b1111
        }

        #[inline]
        #[target_feature(enable = "sse2")]
        pub(crate) fn select_gt(a: Register, b: Register, x: Register, y: Register) -> Register {
            let mask = _mm_cmpgt_ps(a, b);
            _mm_or_ps(_mm_and_ps(mask, x), _mm_andnot_ps(mask, y))
        }

        #[inline]
        #[target_feature(enable = "sse2")]
        pub(crate) fn widen(x: Register) -> [doubles::Register; 2] {
            [_mm_cvtps_pd(x), _mm_cvtps_pd(_mm_movehl_ps(x, x))]
        }

        #[inline]
        #[target_feature(enable = "sse2")]
        pub(crate) fn narrow(low: doubles::Register, high: doubles::Register) -> Register {
            _mm_movelh_ps(_mm_cvtpd_ps(low), _mm_cvtpd_ps(high))
        }
    }
}

pub(crate) mod avx2 {
    pub(crate) mod doubles {
        use core::arch::x86_64::*;
        pub(crate) use core::arch::x86_64::{
            __m256d as Register, _mm256_add_pd as add, _mm256_andnot_pd as andnot, _mm256_div_pd as div,
            _mm256_fmadd_pd as times_plus, _mm256_fnmadd_pd as times_from, _mm256_mul_pd as mul,
            _mm256_set1_pd as splat, _mm256_sub_pd as sub, _mm256_xor_pd as xor,
        };

        turn_back!(
            "avx2,fma",
            _mm256_castpd_si256,
            _mm256_castsi256_pd,
            _mm256_set1_epi64x,
            _mm256_and_si256,
            _mm256_xor_si256,
            _mm256_add_epi64,
            _mm256_sub_epi64,
            _mm256_slli_epi64
        );

        #[inline]
        #[target_feature(enable = "avx2,fma")]
        pub(crate) fn interleave(a: Register, b: Register) -> [Register; 2] {
            // Each half by itself, then the halves in order.
            let (even, odd) = (_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b));
            [_mm256_permute2f128_pd::<0x20>(even, odd), _mm256_permute2f128_pd::<0x31>(even, odd)]
        }

        #[inline]
        #[target_feature(enable = "avx2,fma")]
        pub(crate) fn all_le(a: Register, b: Register) -> bool {
            _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LE_OQ>(a, b)) == 0b1111
        }

        #[inline]
        #[target_feature(enable = "avx2,fma")]
        pub(crate) fn select_gt(a: Register, b: Register, x: Register, y: Register) -> Register {
            _mm256_blendv_pd(y, x, _mm256_cmp_pd::<_CMP_GT_OQ>(a, b))
        }
    }

    pub(crate) mod singles {
        use super::doubles;
        use core::arch::x86_64::*;
        pub(crate) use core::arch::x86_64::{
            __m256 as Register, _mm256_add_ps as add, _mm256_andnot_ps as andnot, _mm256_div_ps as div,
            _mm256_fmadd_ps as times_plus, _mm256_fnmadd_ps as times_from, _mm256_mul_ps as mul,
            _mm256_set1_ps as splat, _mm256_sub_ps as sub, _mm256_xor_ps as xor,
        };

        #[inline]
        #[target_feature(enable = "avx2,fma")]
        pub(crate) fn interleave(a: Register, b: Register) -> [Register; 2] {
            // Each half by itself, then the halves in order.
            let (even, odd) = (_mm256_unpacklo_ps(a, b), _mm256_unpackhi_ps(a, b));
            [_mm256_permute2f128_ps::<0x20>(even, odd), _mm256_permute2f128_ps::<0x31>(even, odd)]
        }

        #[inline]
        #[target_feature(enable = "avx2,fma")]
        pub(crate) fn all_le(a: Register, b: Register) -> bool {
            _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(a, b)) == 0b1111_1111
        }

        #[inline]
        #[target_feature(enable = "avx2,fma")]
        pub(crate) fn select_gt(a: Register, b: Register, x: Register, y: Register) -> Register {
            _mm256_blendv_ps(y, x, _mm256_cmp_ps::<_CMP_GT_OQ>(a, b))
        }

        #[inline]
        #[target_feature(enable = "avx2,fma")]
        pub(crate) fn widen(x: Register) -> [doubles::Register; 2] {
            [_mm256_cvtps_pd(_mm256_castps256_ps128(x)), _mm256_cvtps_pd(_mm256_extractf128_ps::<1>(x))]
        }

        #[inline]
        #[target_feature(enable = "avx2,fma")]
        pub(crate) fn narrow(low: doubles::Register, high: doubles::Register) -> Register {
            _mm256_set_m128(_mm256_cvtpd_ps(high), _mm256_cvtpd_ps(low))
        }
    }
}

pub(crate) mod avx512 {
    pub(crate) mod doubles {
        use core::arch::x86_64::*;
        pub(crate) use core::arch::x86_64::{
            __m512d as Register, _mm512_add_pd as add, _mm512_andnot_pd as andnot, _mm512_div_pd as div,
            _mm512_fmadd_pd as times_plus, _mm512_fnmadd_pd as times_from, _mm512_mul_pd as mul,
            _mm512_set1_pd as splat, _mm512_sub_pd as sub, _mm512_xor_pd as xor,
        };

        turn_back!(
            "avx512f,avx512dq,avx512vl",
            _mm512_castpd_si512,
            _mm512_castsi512_pd,
            _mm512_set1_epi64,
            _mm512_and_si512,
            _mm512_xor_si512,
            _mm512_add_epi64,
            _mm512_sub_epi64,
            _mm512_slli_epi64
        );

        #[inline]
        #[target_feature(enable = "avx512f,avx512dq,avx512vl")]
        pub(crate) fn interleave(a: Register, b: Register) -> [Register; 2] {
            let low = _mm512_setr_epi64(0, 8, 1, 9, 2, 10, 3, 11);
            let high = _mm512_setr_epi64(4, 12, 5, 13, 6, 14, 7, 15);
            [_mm512_permutex2var_pd(a, low, b), _mm512_permutex2var_pd(a, high, b)]
        }

        #[inline]
        #[target_feature(enable = "avx512f,avx512dq,avx512vl")]
        pub(crate) fn all_le(a: Register, b: Register) -> bool {
            _mm512_cmp_pd_mask::<_CMP_LE_OQ>(a, b) == u8::MAX
        }

        #[inline]
        #[target_feature(enable = "avx512f,avx512dq,avx512vl")]
        pub(crate) fn select_gt(a: Register, b: Register, x: Register, y: Register) -> Register {
            _mm512_mask_blend_pd(_mm512_cmp_pd_mask::<_CMP_GT_OQ>(a, b), y, x)
        }
    }

    pub(crate) mod singles {
        use super::doubles;
        use core::arch::x86_64::*;
        pub(crate) use core::arch::x86_64::{
            __m512 as Register, _mm512_add_ps as add, _mm512_andnot_ps as andnot, _mm512_div_ps as div,
            _mm512_fmadd_ps as times_plus, _mm512_fnmadd_ps as times_from, _mm512_mul_ps as mul,
            _mm512_set1_ps as splat, _mm512_sub_ps as sub, _mm512_xor_ps as xor,
        };

        #[inline]
        #[target_feature(enable = "avx512f,avx512dq,avx512vl")]
        pub(crate) fn interleave(a: Register, b: Register) -> [Register; 2] {
            let low = _mm512_setr_epi32(0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
            let high = _mm512_setr_epi32(8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31);
            [_mm512_permutex2var_ps(a, low, b), _mm512_permutex2var_ps(a, high, b)]
        }

        #[inline]
        #[target_feature(enable = "avx512f,avx512dq,avx512vl")]
        pub(crate) fn all_le(a: Register, b: Register) -> bool {
            _mm512_cmp_ps_mask::<_CMP_LE_OQ>(a, b) == u16::MAX
        }

        #[inline]
        #[target_feature(enable = "avx512f,avx512dq,avx512vl")]
        pub(crate) fn select_gt(a: Register, b: Register, x: Register, y: Register) -> Register {
            _mm512_mask_blend_ps(_mm512_cmp_ps_mask::<_CMP_GT_OQ>(a, b), y, x)
        }

        #[inline]
        #[target_feature(enable = "avx512f,avx512dq,avx512vl")]
        pub(crate) fn widen(x: Register) -> [doubles::Register; 2] {
            [_mm512_cvtps_pd(_mm512_castps512_ps256(x)), _mm512_cvtps_pd(_mm512_extractf32x8_ps::<1>(x))]
        }

        #[inline]
        #[target_feature(enable = "avx512f,avx512dq,avx512vl")]
        pub(crate) fn narrow(low: doubles::Register, high: doubles::Register) -> Register {
            _mm512_insertf32x8::<1>(_mm512_castps256_ps512(_mm512_cvtpd_ps(low)), _mm512_cvtpd_ps(high))
        }
    }
}
