% DEFAULTLIMIT  Time limit of a model's runs where the user gave none.
%
% CALL: SECONDS = defaultLimit (DONE, MODEL)
%
%   DONE     1 x n run records so far, see newRecord
%   MODEL    name of the model (text)
%   SECONDS  20 times the median of its runs that ended well, at least 60 s;
%            NaN until three have
%
% See also: executeLocal, executeSlurm

function seconds = defaultLimit (done, model)
  isSame = strcmp ({done.model}, model) & strcmp ({done.status}, 'ok');
  seconds = NaN;
  if sum (isSame) >= 3
    seconds = max (60, 20 * median ([done(isSame).seconds]));
  end
end

%!test
%! done = struct ('model', {'A', 'A', 'B', 'A', 'A'}, 'seconds', ...
%!                {10, 20, 1, 900, 30}, 'status', ...
%!                {'ok', 'ok', 'ok', 'timeout', 'ok'});
%! assert (defaultLimit (done, 'A'), 400);
%! assert (defaultLimit (done, 'B'), NaN);
%! done(4).status = 'ok';
%! done(2).seconds = 1;
%! assert (defaultLimit (done, 'A'), 400);
%! [done.seconds] = deal (1);
%! assert (defaultLimit (done, 'A'), 60);
%!assert (defaultLimit (struct ('model', {}, 'seconds', {}, 'status', {}), ...
%!                      'A'), NaN)
