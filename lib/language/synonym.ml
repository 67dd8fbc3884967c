(* Words of the language, and what others call that. A word of others may stand
   in several rows. *)
let rows =
  [
    ( "reflective",
      "mirror mirrors mirrored mirroring mirrorlike reflection reflections \
       reflect reflecting reflector specular chrome metal metallic polished" );
    ( "diffusive",
      "matte matt mat diffuse diffused diffusion lambert lambertian color \
       colour colored coloured paint painted pigment albedo dull" );
    ( "luminous",
      "emission emissive emit emits emitting emitter emittance glow glows \
       glowing luminance luminescent self-luminous light-emitting unlit" );
    ( "glossy",
      "gloss shiny specular phong highlight highlights polished satin plastic \
       varnished" );
    ( "refractive",
      "refraction refract refracting transparent transparency transmissive \
       transmission clear translucent water" );
    ("glass", "dielectric crystal glassy transparent diamond ice");
    ("mixed", "mix mixes mixture blend blended combine combined layered");
    ("sphere", "ball balls globe orb spheroid");
    ("plane", "floor ground wall ceiling half-space infinite-plane");
    ("box", "cube cuboid block brick");
    ("cylinder", "tube pipe rod column pillar");
    ("cone", "frustum cone-frustum pyramid");
    ("torus", "ring donut doughnut");
    ("disc", "disk circle");
    ("triangle", "tri polygon");
    ("mesh", "model obj ply stl polymesh trimesh triangles polygons faceset");
    ("quad", "rectangle rect square parallelogram quadrangle polygon");
    ( "spherical",
      "point point-light lamp bulb light-bulb omni omnidirectional positional \
       light light-source" );
    ( "directional",
      "sun sunlight sunshine distant distant-light parallel parallel-light \
       light light-source directional-light" );
    ("spot", "spotlight flashlight torch cone-light projector");
    ("area", "area-light soft-light softbox rect-light rectangular-light");
    ( "ambient",
      "ambient-light ambience fill fill-light global-ambient indirect" );
    ("unfading", "no-falloff unattenuated no-attenuation non-fading");
    ("lights", "light lamp lamps lighting sun light-source light-sources");
    ("objects", "object shapes things geometry primitives world");
    ( "bcolor",
      "background background-color background-colour back bg sky sky-color \
       sky-colour backdrop color colour" );
    ( "imWidth",
      "width image-width picture-width pixel-width xres x-resolution \
       resolution size image-size picture-size" );
    ( "imHeight",
      "height image-height picture-height pixel-height yres y-resolution \
       resolution size image-size picture-size" );
    ( "canvWidth",
      "width canvas canvas-width canvas-size screen screen-width viewport \
       viewport-width window film" );
    ( "canvHeight",
      "height canvas canvas-height canvas-size screen screen-height viewport \
       viewport-height window film" );
    ("depth", "distance eye-distance focal-length focal zoom lens");
    ( "eye",
      "camera viewer viewpoint observer camera-position eye-position location \
       look-from from" );
    ( "lookAt",
      "target look-at-point view-point interest point-of-interest \
       camera-target look direction" );
    ("up", "up-vector view-up vup upward upwards");
    ("fov", "field-of-view horizontal-fov hfov angle-of-view view-angle angle");
    ( "raydepth",
      "max-depth maximum-depth recursion recursion-depth recursion-limit \
       max-recursion trace-depth trace-level max-trace-level bounces \
       max-bounces reflections" );
    ( "samples",
      "sample antialias antialiasing anti-aliasing aa smoothing supersampling \
       oversampling subpixels spp samples-per-pixel" );
    ("exposure", "expose brightness bright gain iso ev");
    ("srgb", "gamma gamma-correction encoding color-space colour-space");
    ( "aperture",
      "lens lens-radius iris f-stop fstop blur bokeh defocus dof \
       depth-of-field" );
    ( "focus",
      "focal focal-distance focus-distance focal-plane focal-point dof \
       depth-of-field" );
    ("let", "var def define const val function func fun assign");
    ("for", "repeat while loop foreach");
    ("else", "elif elseif elsif otherwise");
    ("end", "endif endfor endgroup fi done next");
    ("by", "step");
    ("include", "import require");
    ("group", "assembly compound");
    ("cyan", "aqua");
    ("magenta", "fuchsia");
    ("green", "lime");
  ]

let all =
  List.map
    (fun (keyword, words) -> (keyword, String.split_on_char ' ' words))
    rows

let bare word =
  String.lowercase_ascii word
  |> String.to_seq
  |> Seq.filter (fun c -> c <> '-' && c <> '_')
  |> String.of_seq

let table =
  let table = Hashtbl.create 256 in
  let add keyword word =
    let known = Option.value ~default:[] (Hashtbl.find_opt table word) in
    Hashtbl.replace table word (known @ [ keyword ])
  in
  let add_row (keyword, words) =
    List.iter (add keyword) (List.map bare words)
  in
  List.iter add_row all;
  table

let keywords word =
  Option.value ~default:[] (Hashtbl.find_opt table (bare word))
