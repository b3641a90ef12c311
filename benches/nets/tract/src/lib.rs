//! The nets of an ONNX file, run by tract. In wasm plain exports stand in for a binding: JavaScript copies numbers
//! in and out of the memory.

use std::sync::Arc;

use tract_onnx::prelude::*;

pub struct Nets(Arc<TypedRunnableModel>);

impl Nets {
    /// From the bytes of the ONNX file.
    pub fn load(mut onnx: &[u8]) -> TractResult<Nets> {
        let model = tract_onnx::onnx().model_for_read(&mut onnx)?.into_optimized()?;
        Ok(Nets(model.into_runnable()?))
    }

    /// The four maps of a scene, one after the other.
    pub fn imagine(&self, scene: &[f32]) -> TractResult<Vec<f32>> {
        let scene = Tensor::from_shape(&[1, 5, 64, 64], scene)?;
        let mut maps = Vec::with_capacity(4 * 64 * 64);
        for map in self.0.run(tvec!(scene.into()))? {
            maps.extend_from_slice(map.to_plain_array_view::<f32>()?.as_slice().expect("contiguous"));
        }
        Ok(maps)
    }
}

#[cfg(target_arch = "wasm32")]
mod exports {
    use super::Nets;

    /// Room for so many bytes, never given back.
    #[unsafe(no_mangle)]
    pub extern "C" fn room(bytes: usize) -> *mut u8 {
        Box::leak(vec![0_u128; bytes.div_ceil(16)].into_boxed_slice()).as_mut_ptr().cast()
    }

    /// # Safety
    /// The bytes of the ONNX file lie in `room`.
    #[unsafe(no_mangle)]
    pub unsafe extern "C" fn load(onnx: *const u8, length: usize) -> *const Nets {
        let onnx = unsafe { std::slice::from_raw_parts(onnx, length) };
        Box::leak(Box::new(Nets::load(onnx).expect("the file is tract's to read")))
    }

    /// # Safety
    /// `scene` is room for 5 x 64 x 64 numbers, `maps` for 4 x 64 x 64.
    #[unsafe(no_mangle)]
    pub unsafe extern "C" fn imagine(nets: &Nets, scene: *const f32, maps: *mut f32) {
        let scene = unsafe { std::slice::from_raw_parts(scene, 5 * 64 * 64) };
        let found = nets.imagine(scene).expect("the shapes are right");
        unsafe { std::slice::from_raw_parts_mut(maps, 4 * 64 * 64) }.copy_from_slice(&found);
    }
}
