let[@inline] ( .%() ) (a : float array) i = Array.unsafe_get a i
