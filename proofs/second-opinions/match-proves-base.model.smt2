; A model of the hypotheses of match-proves-base.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. S knows v0, where the marker points to a0; h = A1, x = a1.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((MapDart 0)) (((A0) (A1) (B0) (B1) (C0) (C1))))
(declare-datatypes ((Turn 0)) (((zero) (one))))
(define-fun turn ((x0 Turn) (x1 Dart)) Dart
  (ite (and (= x0 one) (= x1 a0)) a1 (ite (and (= x0 one) (= x1 a1)) a0
  (ite (and (= x0 one) (= x1 b0)) b1 (ite (and (= x0 one) (= x1 b1)) b0
  (ite (and (= x0 one) (= x1 c0)) c1 (ite (and (= x0 one) (= x1 c1)) c0 x1)))))))
(define-fun unturn ((x0 Turn) (x1 Dart)) Dart
  (ite (and (= x0 one) (= x1 a0)) a1 (ite (and (= x0 one) (= x1 a1)) a0
  (ite (and (= x0 one) (= x1 b0)) b1 (ite (and (= x0 one) (= x1 b1)) b0
  (ite (and (= x0 one) (= x1 c0)) c1 (ite (and (= x0 one) (= x1 c1)) c0 x1)))))))
(define-fun turn_map ((x0 Turn) (x1 MapDart)) MapDart
  (ite (and (= x0 one) (= x1 A0)) A1 (ite (and (= x0 one) (= x1 A1)) A0
  (ite (and (= x0 one) (= x1 B0)) B1 (ite (and (= x0 one) (= x1 B1)) B0
  (ite (and (= x0 one) (= x1 C0)) C1 (ite (and (= x0 one) (= x1 C1)) C0 x1)))))))
(define-fun phi ((x MapDart)) Dart
  (ite (= x A0) a0 (ite (= x A1) a1 (ite (= x B0) b0 (ite (= x B1) b1 (ite (= x C0) c0 c1))))))
(define-fun known ((x MapDart)) Bool (or (= x A0) (= x A1)))
(define-fun marked ((x Dart)) Bool (or (= x a0) (= x a1)))
(define-fun home ((x MapDart)) Bool (or (= x A0) (= x A1)))
(define-fun bearing ((x Dart)) Turn (ite (= x a1) one zero))
(define-fun expected ((x MapDart)) Turn (ite (= x A1) one zero))
(define-fun pointed () Dart a0)
(define-fun pointed_map () MapDart A0)
(define-fun h () MapDart A1)
(define-fun x () Dart a1)

(assert (forall ((b Turn) (d Dart)) (= (unturn b (turn b d)) d)))
(assert (forall ((d Dart)) (=> (marked d) (= (turn (bearing d) d) pointed))))
(assert (forall ((e MapDart))
  (=> (and (known e) (home e)) (= (turn_map (expected e) e) pointed_map))))
(assert (forall ((b Turn) (e MapDart)) (=> (known e) (= (phi (turn_map b e)) (turn b (phi e))))))
(assert (= (phi pointed_map) pointed))
(assert (known h))
(assert (home h))
(assert (marked x))
(assert (= (bearing x) (expected h)))
(check-sat)
