; A model of the hypotheses of turns-carried-over.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. S knows v0 and v1; k = 1, e = B1.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((MapDart 0)) (((A0) (A1) (B0) (B1) (C0) (C1))))
(define-fun phi ((x MapDart)) Dart
  (ite (= x A0) a0 (ite (= x A1) a1 (ite (= x B0) b0 (ite (= x B1) b1 (ite (= x C0) c0 c1))))))
(define-fun known ((x MapDart)) Bool (or (= x A0) (= x A1) (= x B0) (= x B1)))
(define-fun sigma ((x Dart)) Dart
  (ite (= x a0) a1 (ite (= x a1) a0 (ite (= x b0) b1 (ite (= x b1) b0 (ite (= x c0) c1 c0))))))
(define-fun next ((x MapDart)) MapDart
  (ite (= x A0) A1 (ite (= x A1) A0 (ite (= x B0) B1 (ite (= x B1) B0 (ite (= x C0) C1 C0))))))
(define-fun turn_k ((x Dart)) Dart
  (ite (= x a0) a1 (ite (= x a1) a0 (ite (= x b0) b1 (ite (= x b1) b0 (ite (= x c0) c1 c0))))))
(define-fun turn_k1 ((x Dart)) Dart
  (ite (= x a0) a0 (ite (= x a1) a1 (ite (= x b0) b0 (ite (= x b1) b1 (ite (= x c0) c0 c1))))))
(define-fun turn_map_k ((x MapDart)) MapDart
  (ite (= x A0) A1 (ite (= x A1) A0 (ite (= x B0) B1 (ite (= x B1) B0 (ite (= x C0) C1 C0))))))
(define-fun turn_map_k1 ((x MapDart)) MapDart
  (ite (= x A0) A0 (ite (= x A1) A1 (ite (= x B0) B0 (ite (= x B1) B1 (ite (= x C0) C0 C1))))))
(define-fun e () MapDart B1)

(assert (forall ((x MapDart))
  (=> (known x) (and (known (next x)) (= (phi (next x)) (sigma (phi x)))))))
(assert (forall ((d Dart)) (= (turn_k1 d) (sigma (turn_k d)))))
(assert (forall ((x MapDart)) (= (turn_map_k1 x) (next (turn_map_k x)))))
(assert (forall ((x MapDart))
  (=> (known x) (and (known (turn_map_k x)) (= (phi (turn_map_k x)) (turn_k (phi x)))))))
(assert (known e))
(check-sat)
