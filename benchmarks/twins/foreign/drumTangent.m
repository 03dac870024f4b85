% DRUMTANGENT  Tangent of the slope in a turning drum grows with Froude number.
%
% CALL: S = drumTangent (REST, FROUDE, LAW)
%
%   REST    n x 1, tangent at rest
%   FROUDE  n x m or 1 x m, omega^2 R / g
%   LAW     struct of scalars or n x 1: rise (0.9), power (0.5), lift (1.5),
%           from (Froude number above which grains are thrown, 0.08)
%   S       n x m, rest + rise Fr^power + lift max (0, Fr - from)
%
% See also: reposeTangent, foreignLab

function S = drumTangent (rest, froude, law)
  S = rest + law.rise .* froude.^law.power + ...
      law.lift .* max (0, froude - law.from);
end

%!test % at rest the angle of repose, then monotone with a kink
%! law = struct ('rise', 0.9, 'power', 0.5, 'lift', 1.5, 'from', 0.08);
%! S = drumTangent (0.5, [0, 0.02, 0.08, 0.2], law);
%! assert (S([1, 3]), 0.5 + 0.9 * sqrt ([0, 0.08]), 1e-12);
%! assert (S(4), 0.5 + 0.9 * sqrt (0.2) + 0.18, 1e-12);
