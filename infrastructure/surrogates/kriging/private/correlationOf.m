% CORRELATIONOF  Correlation functions of the surrogates, and their slope.
%
% CALL: [K, SLOPE] = correlationOf (KERNEL, R2)
%
% KERNEL  'matern32', 'matern52' or 'gauss'
% R2      squared scaled distances, any size
% K       correlation; SLOPE  its derivative by r2 (both as r2)
%
% The same scaling of the distance as stk: t = 2 sqrt (nu) r.
%
% Errors: DEcalioc:correlationOf:unknownName

function [k, slope] = correlationOf (kernel, r2)
  switch kernel
    case 'matern52'
      t = sqrt (10 * r2);
      e = exp (-t);
      k = (1 + t + t.^2 / 3) .* e;
      slope = -10 / 6 * (1 + t) .* e;
    case 'matern32'
      t = sqrt (6 * r2);
      e = exp (-t);
      k = (1 + t) .* e;
      slope = -3 * e;
    case 'gauss'
      k = exp (-r2);
      slope = -k;
    otherwise
      error ('DEcalioc:correlationOf:unknownName', ...
             ['correlationOf: KERNEL must be matern32, matern52 or gauss, ' ...
              'got %s.'], kernel);
  end
end

%!assert (correlationOf ('gauss', [0, 1]), [1, exp(-1)], 1e-15)
%!assert (correlationOf ('matern52', 0), 1)
%!error id=DEcalioc:correlationOf:unknownName correlationOf ('cubic', 1);
