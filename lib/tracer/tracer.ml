let color prepared ray = Evaluator.color (Evaluator.create prepared) ray
let pixel prepared ~x ~y = Sampler.lone_pixel (Sampler.create prepared) ~x ~y

let nearest_hit prepared ray =
  Evaluator.nearest_hit (Evaluator.create prepared) ray

let light prepared hit = Evaluator.light (Evaluator.create prepared) hit
