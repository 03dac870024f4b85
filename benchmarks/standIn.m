% STANDIN  Cheap formulas in the place of a DEM model, with known truth.
%
% CALL: S = standIn (name)
%
% name  'plain': 5 parameters, 2 targets, the limits of the published example,
%       almost linear; 'noisy': the same with the scatter of the container
%       Lift100, 0.35 % and 3.3 %; 'rough': 6 parameters, 4 targets, with an
%       interaction, a plateau and a kink
% S     struct: name, names 1 x d, limits 2 x d, targetNames, value 1 x T,
%       response (handle, n x d -> n x T, no noise), noise (relative sd of a
%       run, scalar or 1 x T)
%
% The rough one has its targets at the inner set 0.55 0.5 0.6 0.4 0.5 0.5, in
% box widths. benchmarks/peers.py holds the same formulas.
%
% See also: calibrateStandIn

function S = standIn (name)
  S.name = name;
  S.noise = 0.01;
  switch name
    case {'plain', 'noisy'}
      S.names = {'rho', 'mu_pp', 'mu_pw', 'mr_pp', 'mr_pw'};
      S.limits = [500, 0.3, 0.3, 0.025, 0.025; 800, 0.7, 0.7, 0.075, 0.075];
      S.targetNames = {'density', 'mass'};
      S.value = [400, 0.028];
      S.response = @plain;
      if strcmp (name, 'noisy')
        S.noise = [0.0035, 0.033];
      end
    case 'rough'
      S.names = {'a', 'b', 'c', 'd', 'e', 'f'};
      S.limits = [zeros(1, 6); ones(1, 6)];
      S.targetNames = {'angle', 'flow', 'mass', 'force'};
      S.response = @rough;
      S.value = rough ([0.55, 0.5, 0.6, 0.4, 0.5, 0.5]);
    otherwise
      error ('DEcalioc:standIn:unknownName', ...
             'standIn: NAME must be plain, noisy or rough, got %s.', name);
  end
end

function Z = plain (P)
  Z = [P(:, 1) .* (0.62 - 0.06 * P(:, 2) - 0.25 * P(:, 4)), ...
       0.01 + 0.02 * P(:, 2) + 0.01 * P(:, 3) + 0.05 * P(:, 4) + ...
       0.01 * P(:, 5)];
end

function Z = rough (P)
  Z = [18 + 14 * P(:, 1) .* (0.4 + 0.6 * P(:, 2)) + 4 * P(:, 3), ...
       60 + 40 * tanh(4 * (P(:, 2) - 0.45)) - 15 * P(:, 4), ...
       3 + 5 * max(0, P(:, 3) - 0.35) + 2 * P(:, 1) .* P(:, 5), ...
       0.02 * exp(1.5 * P(:, 6)) .* (1 + 0.4 * P(:, 4))];
end

%!test
%! S = standIn ('plain');
%! assert (S.response ([700, 0.5, 0.5, 0.05, 0.05]), ...
%!         [403.9583, 0.028], [0.7, 1e-9]);
%! S = standIn ('rough');
%! assert (S.value, [25.79, 61.895, 4.8, 0.049115], 1e-3);
