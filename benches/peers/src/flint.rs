//! The functions of FLINT's C library that the kernels call, loaded when the program starts.

use std::env;
use std::ffi::{CStr, c_char, c_int, c_long, c_ulong, c_void};
use std::ptr;

use libloading::{Error, Library};

/// FLINT's integer: a small value in the word itself, or a tagged pointer to a GMP integer.
pub type Fmpz = c_long;

/// FLINT's fraction. Canonical: in lowest terms, the denominator positive.
#[repr(C)]
pub struct Fmpq {
    pub num: Fmpz,
    pub den: Fmpz,
}

macro_rules! functions {
    ($(fn $name:ident($($argument:ident: $type:ty),*) $(-> $result:ty)?;)*) => {
        pub struct Flint {
            $($name: unsafe extern "C" fn($($type),*) $(-> $result)?,)*
            version: *const c_char,
            _library: Library,
        }

        impl Flint {
            fn open(path: &std::ffi::OsStr) -> Result<Flint, Error> {
                // SAFETY: FLINT's initialisers have no preconditions; the types below are those of its headers.
                unsafe {
                    let library = Library::new(path)?;
                    Ok(Flint {
                        $($name: *library.get(stringify!($name))?,)*
                        version: *library.get::<*const c_char>("flint_version")?,
                        _library: library,
                    })
                }
            }

            $(
                /// # Safety
                /// Every pointer must be valid for what FLINT's manual says this function reads and writes.
                #[inline(always)]
                pub unsafe fn $name(&self, $($argument: $type),*) $(-> $result)? {
                    unsafe { (self.$name)($($argument),*) }
                }
            )*
        }
    };
}

functions! {
    fn fmpz_set(to: *mut Fmpz, from: *const Fmpz);
    fn fmpz_mul(to: *mut Fmpz, a: *const Fmpz, b: *const Fmpz);
    fn fmpz_mul_ui(to: *mut Fmpz, a: *const Fmpz, b: c_ulong);
    fn fmpz_addmul(to: *mut Fmpz, a: *const Fmpz, b: *const Fmpz);
    fn fmpz_submul(to: *mut Fmpz, a: *const Fmpz, b: *const Fmpz);
    fn fmpz_divexact(to: *mut Fmpz, a: *const Fmpz, b: *const Fmpz);
    fn fmpz_divexact_ui(to: *mut Fmpz, a: *const Fmpz, b: c_ulong);
    fn fmpz_fdiv_ui(a: *const Fmpz, b: c_ulong) -> c_ulong;
    fn fmpz_lcm(to: *mut Fmpz, a: *const Fmpz, b: *const Fmpz);
    fn fmpz_fmma(to: *mut Fmpz, a: *const Fmpz, b: *const Fmpz, c: *const Fmpz, d: *const Fmpz);
    fn fmpz_fmms(to: *mut Fmpz, a: *const Fmpz, b: *const Fmpz, c: *const Fmpz, d: *const Fmpz);
    fn fmpz_add(to: *mut Fmpz, a: *const Fmpz, b: *const Fmpz);
    fn fmpz_cmp(a: *const Fmpz, b: *const Fmpz) -> c_int;
    fn fmpz_sub(to: *mut Fmpz, a: *const Fmpz, b: *const Fmpz);
    fn _fmpz_clear_mpz(x: Fmpz);
    fn _fmpz_vec_init(length: c_long) -> *mut Fmpz;
    fn _fmpz_vec_clear(vector: *mut Fmpz, length: c_long);
    fn _fmpz_poly_mul(to: *mut Fmpz, a: *const Fmpz, a_length: c_long, b: *const Fmpz, b_length: c_long);
    fn _fmpz_poly_taylor_shift(polynomial: *mut Fmpz, by: *const Fmpz, length: c_long);
    fn fmpq_set(to: *mut Fmpq, from: *const Fmpq);
    fn fmpq_set_si(to: *mut Fmpq, num: c_long, den: c_ulong);
    fn fmpq_set_fmpz_frac(to: *mut Fmpq, num: *const Fmpz, den: *const Fmpz);
    fn fmpq_get_str(buffer: *mut c_char, base: c_int, x: *const Fmpq) -> *mut c_char;
    fn n_gcd(a: c_ulong, b: c_ulong) -> c_ulong;
    fn flint_free(memory: *mut c_void);
}

impl Flint {
    /// Loads the library that the environment variable `FLINT_LIBRARY` names. It stays loaded until the program ends.
    pub fn load() -> &'static Flint {
        let path = env::var_os("FLINT_LIBRARY").expect("FLINT_LIBRARY must be the path of libflint.so");
        Box::leak(Box::new(Flint::open(&path).expect("FLINT_LIBRARY is not a FLINT 3 library")))
    }

    pub fn version(&self) -> String {
        // SAFETY: `flint_version` is a constant C string.
        unsafe { CStr::from_ptr(self.version) }.to_string_lossy().into_owned()
    }

    /// `fmpz_clear`, which is inline in FLINT's header: only big values own memory.
    ///
    /// # Safety
    /// `x` must be initialised, and not be used again.
    #[inline(always)]
    pub unsafe fn fmpz_clear(&self, x: Fmpz) {
        if x >> 62 == 1 {
            unsafe { self._fmpz_clear_mpz(x) }
        }
    }
}

/// Temporary integers of a kernel, all zero at first.
pub struct Integers {
    flint: &'static Flint,
    first: *mut Fmpz,
    length: c_long,
}

impl Integers {
    pub fn new(flint: &'static Flint, length: usize) -> Integers {
        let length = length as c_long;
        // SAFETY: any length is allowed.
        let first = unsafe { flint._fmpz_vec_init(length) };
        Integers { flint, first, length }
    }

    pub fn at(&self, index: usize) -> *mut Fmpz {
        debug_assert!((index as c_long) < self.length);
        // SAFETY: inside the allocation of `length` words.
        unsafe { self.first.add(index) }
    }
}

impl Drop for Integers {
    fn drop(&mut self) {
        // SAFETY: made by `_fmpz_vec_init` with this length, and cleared once.
        unsafe { self.flint._fmpz_vec_clear(self.first, self.length) }
    }
}

/// One temporary integer of a kernel, zero at first, inline as in C.
pub struct Integer {
    flint: &'static Flint,
    value: Fmpz,
}

impl Integer {
    pub fn new(flint: &'static Flint, value: i32) -> Integer {
        Integer { flint, value: value.into() }
    }

    pub fn at(&mut self) -> *mut Fmpz {
        &raw mut self.value
    }
}

impl Drop for Integer {
    fn drop(&mut self) {
        // SAFETY: initialised by `new`, and cleared once.
        unsafe { self.flint.fmpz_clear(self.value) }
    }
}

/// Canonical fractions: the inputs and outputs of the kernels.
pub struct Fractions {
    flint: &'static Flint,
    entries: Vec<Fmpq>,
}

impl Fractions {
    pub fn zeros(flint: &'static Flint, length: usize) -> Fractions {
        let entries = (0..length).map(|_| Fmpq { num: 0, den: 1 }).collect();
        Fractions { flint, entries }
    }

    pub fn new(flint: &'static Flint, values: &[(i64, u64)]) -> Fractions {
        let mut fractions = Fractions::zeros(flint, values.len());
        for (entry, &(num, den)) in fractions.entries.iter_mut().zip(values) {
            // SAFETY: `entry` is an initialised fraction, and no denominator of ours is zero.
            unsafe { flint.fmpq_set_si(entry, num, den) }
        }
        fractions
    }

    pub fn len(&self) -> usize {
        self.entries.len()
    }

    pub fn at(&self, index: usize) -> &Fmpq {
        &self.entries[index]
    }

    pub fn at_mut(&mut self, index: usize) -> *mut Fmpq {
        &raw mut self.entries[index]
    }

    /// The fractions as FLINT writes them: `-7/3`, and `5` for an integer.
    pub fn to_strings(&self) -> Vec<String> {
        let text = |entry: &Fmpq| {
            // SAFETY: a null buffer makes FLINT allocate one, which we give back.
            unsafe {
                let buffer = self.flint.fmpq_get_str(ptr::null_mut(), 10, entry);
                let text = CStr::from_ptr(buffer).to_string_lossy().into_owned();
                self.flint.flint_free(buffer.cast());
                text
            }
        };
        self.entries.iter().map(text).collect()
    }
}

impl Drop for Fractions {
    fn drop(&mut self) {
        for entry in &self.entries {
            // SAFETY: both words are initialised integers, and cleared once.
            unsafe {
                self.flint.fmpz_clear(entry.num);
                self.flint.fmpz_clear(entry.den);
            }
        }
    }
}
