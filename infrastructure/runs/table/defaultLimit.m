% DEFAULTLIMIT  Time limit of a model's runs where the user gave none.
%
% CALL: SECONDS = defaultLimit (MODEL)
%       SECONDS = defaultLimit (MODEL, DONE)
%
%   MODEL    scalar struct, one of Case.models; its field seconds holds how
%            long earlier runs of the calibration took, see addSeconds; its
%            field least (optional), what a run is to get at least (s)
%   DONE     1 x n run records of the present call, see newRecord (default:
%            none)
%   SECONDS  20 times the median of the model's runs that ended well, twice the
%            longest of them and 60 s, whichever is most; twice the longest that
%            was cut off where at least as many were cut off as ended well, for
%            those that are left tell of the quick ones alone. NaN until three
%            are known, and where Input.timeout is given

function seconds = defaultLimit (model, done)
  seconds = NaN;
  known = model.seconds;
  if nargin > 1
    known = addSeconds (model, done).seconds;
  end
  if ~isnan (model.timeout)
    return
  end
  well = known(known >= 0);
  cut = -known(known < 0);
  least = givenField (model, 'least', 0);
  if numel (known) >= 3
    seconds = max ([60, 2 * max(well), least]);
    if numel (cut) >= numel (well)
      seconds = max (seconds, 2 * max (cut));
    else
      seconds = max (seconds, 20 * median (well));
    end
  elseif least > 0
    seconds = least;
  end
end

%!shared done, model
%! done = struct ('model', {'A', 'A', 'B', 'A', 'A'}, 'seconds', ...
%!                {10, 20, 1, 900, 30}, 'status', ...
%!                {'ok', 'ok', 'ok', 'failed', 'ok'}, 'effects', [], ...
%!                'cause', '');
%! model = struct ('name', 'A', 'timeout', NaN, 'seconds', [], 'coarse', []);
%!test
%! assert (defaultLimit (model, done), 400);
%! assert (defaultLimit (setfield (model, 'name', 'B'), done), NaN);
%! assert (defaultLimit (setfield (model, 'timeout', 9), done), NaN);
%! done(4).status = 'ok';
%! done(2).seconds = 1;
%! assert (defaultLimit (model, done), 1800);
%! [done.seconds] = deal (1);
%! assert (defaultLimit (model, done), 60);
%!test
%! % runs of earlier calls count
%! known = setfield (model, 'seconds', [100, 100, 100, 100]);
%! assert (defaultLimit (known, done), 20 * 50.5);
%! assert (defaultLimit (known), 2000);
%!test
%! % those that were cut off: few of many are taken for ones that hang
%! limit = @(seconds) defaultLimit (setfield (model, 'seconds', seconds));
%! assert (limit ([1, 1, 1, 1, -60, -60]), 60);
%! assert (limit ([1, 1, -60, -60]), 120);
%! assert (limit ([-60, -60, -120]), 240);
%! assert (limit ([1, 1, 66, 1]), 132);
%! assert (limit ([1, 2]), NaN);
%! assert (defaultLimit (setfield (model, 'least', 120)), 120);
%! patient = setfield (model, 'seconds', [1, 1, 1]);
%! assert (defaultLimit (setfield (patient, 'least', 120)), 120);

% SPDX-License-Identifier: GPL-3.0-only
