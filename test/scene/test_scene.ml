let () =
  Alcotest.run "scene"
    [
      Test_level.suite;
      Test_saturate.suite;
      Test_color.suite;
      Test_grey.suite;
      Test_surface.suite;
      Test_raw_lobes.suite;
      Test_lobes.suite;
      Test_light.suite;
      Test_lamps.suite;
      Test_shadow_ray.suite;
      Test_viewpoint.suite;
      Test_camera.suite;
      Test_film.suite;
      Test_spread.suite;
      Test_projection.suite;
      Test_scenes.suite;
      Test_warnings.suite;
      Test_proportions.suite;
      Test_byte_colors.suite;
      Test_kept_in.suite;
      Test_twins.suite;
    ]
