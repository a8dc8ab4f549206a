; Turning is reversible: induction step over the number of places turned
; Says: If sigma^k has an inverse, so has sigma^(k+1): first one place back, then k places back.
; Paper: II-B (edges round a vertex are enumerated in a fixed cyclic order), IV line 14
; Symbols:
;   Dart               the darts of the world G: an edge seen from one of its ends
;   sigma, sigma_inv   the next dart clockwise, anticlockwise, round the same vertex
;   turn_k, back_k     sigma^k and its inverse;  turn_k1, back_k1: the same for k+1
;   d                  the dart where the claim fails
; Expected: unsat

(set-logic UF)
(declare-sort Dart 0)
(declare-fun sigma (Dart) Dart)
(declare-fun sigma_inv (Dart) Dart)
(declare-fun turn_k (Dart) Dart)
(declare-fun back_k (Dart) Dart)
(declare-fun turn_k1 (Dart) Dart)
(declare-fun back_k1 (Dart) Dart)
(declare-const d Dart)

; sigma is a permutation
(assert (forall ((x Dart)) (= (sigma_inv (sigma x)) x)))
(assert (forall ((x Dart)) (= (sigma (sigma_inv x)) x)))
; k+1 places: one more after k; and back: one first
(assert (forall ((x Dart)) (= (turn_k1 x) (sigma (turn_k x)))))
(assert (forall ((x Dart)) (= (back_k1 x) (back_k (sigma_inv x)))))
; induction hypothesis
(assert (forall ((x Dart)) (= (back_k (turn_k x)) x)))
(assert (forall ((x Dart)) (= (turn_k (back_k x)) x)))

; not: the same for k+1
(assert (not (and (= (back_k1 (turn_k1 d)) d) (= (turn_k1 (back_k1 d)) d))))
(check-sat)
