(** What a session opens: all that a learner types, in one module.

    [raylab repl] and [dune utop lib] open it by themselves; elsewhere say
    [open Raylab_toplevel.Prelude]. *)

(** {1 The words} *)

include module type of struct
  include Explore
end

include module type of struct
  include Build
end

(** {1 The library} *)

module Vec3 = Raylab_geometry.Vec3
module Direction = Raylab_geometry.Direction
module Ray = Raylab_geometry.Ray
module Box3 = Raylab_geometry.Box3
module Shape = Raylab_geometry.Shape
module Sphere = Raylab_geometry.Sphere
module Plane = Raylab_geometry.Plane
module Box = Raylab_geometry.Box
module Cylinder = Raylab_geometry.Cylinder
module Cone = Raylab_geometry.Cone
module Torus = Raylab_geometry.Torus
module Disc = Raylab_geometry.Disc
module Triangle = Raylab_geometry.Triangle
module Quad = Raylab_geometry.Quad
module Place = Raylab_source.Place
module Color = Raylab_scene.Color
module Grey = Raylab_scene.Grey
module Lobes = Raylab_scene.Lobes
module Surface = Raylab_scene.Surface
module Light = Raylab_scene.Light
module Origin = Raylab_scene.Origin
module Object = Raylab_scene.Object
module Viewpoint = Raylab_scene.Viewpoint
module Film = Raylab_scene.Film
module Lens = Raylab_scene.Lens
module Camera = Raylab_scene.Camera
module Scene = Raylab_scene.Scene
module Scene_file = Raylab_language.Scene_file
module Scene_error = Raylab_language.Scene_error
module Prepared = Raylab_tracer.Prepared
module Hit = Raylab_tracer.Hit
module Event = Raylab_tracer.Event
module Tracer = Raylab_tracer.Tracer
module Explain = Raylab_tracer.Explain
module Report = Raylab_explanation.Report
module Path_picture = Raylab_drawing.Path_picture
module Picture = Raylab_tracer.Picture
module Tally = Raylab_tracer.Tally
module Render = Raylab_tracer.Render
module Picture_file = Raylab_picture.Picture_file

(** How values are shown; utop installs these by itself. *)
module Printers : module type of struct
  include Printers
end
