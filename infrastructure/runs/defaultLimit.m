% DEFAULTLIMIT  Time limit of a model's runs where the user gave none.
%
% CALL: SECONDS = defaultLimit (MODEL)
%       SECONDS = defaultLimit (MODEL, DONE)
%
%   MODEL    scalar struct, one of Case.models; its field seconds holds how
%            long earlier runs of the calibration took
%   DONE     1 x n run records of the present call, see newRecord (default:
%            none)
%   SECONDS  20 times the median of the model's runs that ended well, at least
%            60 s; NaN until three have, and where Input.timeout is given

function seconds = defaultLimit (model, done)
  seconds = NaN;
  known = model.seconds;
  if nargin > 1
    known = addSeconds (model, done).seconds;
  end
  if isnan (model.timeout) && numel (known) >= 3
    seconds = max (60, 20 * median (known));
  end
end

%!shared done, model
%! done = struct ('model', {'A', 'A', 'B', 'A', 'A'}, 'seconds', ...
%!                {10, 20, 1, 900, 30}, 'status', ...
%!                {'ok', 'ok', 'ok', 'timeout', 'ok'}, 'effects', []);
%! model = struct ('name', 'A', 'timeout', NaN, 'seconds', [], 'coarse', []);
%!test
%! assert (defaultLimit (model, done), 400);
%! assert (defaultLimit (setfield (model, 'name', 'B'), done), NaN);
%! assert (defaultLimit (setfield (model, 'timeout', 9), done), NaN);
%! done(4).status = 'ok';
%! done(2).seconds = 1;
%! assert (defaultLimit (model, done), 400);
%! [done.seconds] = deal (1);
%! assert (defaultLimit (model, done), 60);
%!test
%! % runs of earlier calls count
%! known = setfield (model, 'seconds', [100, 100, 100, 100]);
%! assert (defaultLimit (known, done), 20 * 50.5);
%! assert (defaultLimit (known), 2000);
