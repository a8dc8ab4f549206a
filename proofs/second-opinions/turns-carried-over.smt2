; Turning in S is turning in G: induction step over the number of places turned
; Says: The edge-index condition says that phi carries the next dart clockwise of S to that of G.
;   Then it carries the k-th dart clockwise to the k-th: true for k, hence for k+1.
; Paper: V, edge-index condition
; Symbols:
;   Dart, MapDart  the darts of the world G; the darts of the map S
;   phi            the dart of G that a dart of S stands for (the paper's phi)
;   known          the dart is in S (its vertex is)
;   sigma, next            the next dart clockwise, in G and in S
;   turn_k, turn_map_k     k places clockwise, in G and in S;  turn_k1, turn_map_k1: k+1 places
;   e                      the dart of S where the claim fails
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-sort MapDart 0)
(declare-fun phi (MapDart) Dart)
(declare-fun known (MapDart) Bool)
(declare-fun sigma (Dart) Dart)
(declare-fun next (MapDart) MapDart)
(declare-fun turn_k (Dart) Dart)
(declare-fun turn_k1 (Dart) Dart)
(declare-fun turn_map_k (MapDart) MapDart)
(declare-fun turn_map_k1 (MapDart) MapDart)
(declare-const e MapDart)

; the edge-index condition
(assert (forall ((x MapDart))
  (=> (known x) (and (known (next x)) (= (phi (next x)) (sigma (phi x)))))))
; k+1 places: one more after k
(assert (forall ((d Dart)) (= (turn_k1 d) (sigma (turn_k d)))))
(assert (forall ((x MapDart)) (= (turn_map_k1 x) (next (turn_map_k x)))))
; induction hypothesis
(assert (forall ((x MapDart))
  (=> (known x) (and (known (turn_map_k x)) (= (phi (turn_map_k x)) (turn_k (phi x)))))))
; a dart of S
(assert (known e))

; not: the same for k+1
(assert (not (and (known (turn_map_k1 e)) (= (phi (turn_map_k1 e)) (turn_k1 (phi e))))))
(check-sat)
