//! The static bodies of a scene as a picture, drawn once: without a GPU they are half the work of a frame.

use std::cell::RefCell;

use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use super::paint::Painter;
use crate::puzzle::scene::Scene;

/// The picture of one scene, with the side and the theme for which it was drawn.
#[derive(Default)]
pub(crate) struct StaticLayer(RefCell<Option<(u32, bool, HtmlCanvasElement)>>);

impl StaticLayer {
    /// Draws the static bodies of the scene, at the opacity of the context.
    pub(crate) fn draw(&self, painter: &Painter, scene: &Scene) -> Result<(), JsValue> {
        let (side, dark) = (painter.side() as u32, painter.dark);
        let kept = self.0.take().filter(|picture| (picture.0, picture.1) == (side, dark));
        let canvas = kept.map_or_else(|| drawn(painter, scene), |(.., canvas)| Ok(canvas))?;
        painter.overlay(&canvas, painter.context.global_alpha())?;
        self.0.replace(Some((side, dark, canvas)));
        Ok(())
    }
}

fn drawn(painter: &Painter, scene: &Scene) -> Result<HtmlCanvasElement, JsValue> {
    let document = painter.context.canvas().and_then(|canvas| canvas.owner_document());
    let canvas = document.ok_or("the canvas belongs to no document")?.create_element("canvas")?;
    let canvas: HtmlCanvasElement = canvas.unchecked_into();
    canvas.set_width(painter.side() as u32);
    canvas.set_height(painter.side() as u32);
    let context: CanvasRenderingContext2d = canvas.get_context("2d")?.ok_or("no context")?.unchecked_into();
    Painter::new(&context, painter.dark)?.bodies(scene, false, |_| None)?;
    Ok(canvas)
}
