let () =
  Alcotest.run "tracer"
    [
      Test_picture.suite;
      Test_prepared.suite;
      Test_hit.suite;
      Test_visibility.suite;
      Test_lighting.suite;
      Test_shine.suite;
      Test_shadows.suite;
      Test_mirrors.suite;
      Test_glass.suite;
      Test_edge_cases.suite;
      Test_offset.suite;
      Test_acne.suite;
      Test_scale.suite;
      Test_motion.suite;
      Test_semantics.suite;
      Test_any_scene.suite;
      Test_render.suite;
      Test_tally.suite;
      Test_sampler.suite;
    ]
