% TARGETCOLUMNS  Measured values for a cost function, one row a target.
%
% CALL: [VALUE, SCALE] = targetColumns (INPUT, OPTIM)
%
%   INPUT  Input of loadInput
%   OPTIM  optim of loadInput
%   VALUE  T x 1, in the order of the results that a cost function gets; NaN:
%          not measured yet
%   SCALE  T x 1, what a residual is divided by: the value, or 1 where the
%          tolerance is absolute
%
% From measured.csv in the folder of the case, where there is one, else from
% optim.targetVal.
%
% See also: costFunction, newTargets

function [value, scale] = targetColumns (Input, optim)
  root = fileparts (fileparts (fileparts (mfilename ('fullpath'))));
  folder = caseFolder (root);
  if isfile (fullfile (folder, 'measured.csv'))
    models = struct ('name', cellstr (Input.model)(:)');
    targets = newTargets (optim, models, folder);
    value = [targets.value]';
    scale = value;
    scale([targets.isAbsolute]) = 1;
  else
    value = asColumn (optim.targetVal);
    scale = value;
  end
end

%!assert (targetColumns (struct (), struct ('targetVal', {{[1, 2], 3}})), ...
%!        [1; 2; 3])
%!test
%! folder = tempname ();
%! mkdir (folder);
%! writeAtomic (fullfile (folder, 'measured.csv'), ...
%!              "model,name,value,tol\nB,b,0,1\nA,a,4,0.1\nA,c,,\n");
%! here = cd (folder);
%! unwind_protect
%!   [value, scale] = targetColumns (struct ('model', {{'A', 'B'}}), ...
%!                                   struct ());
%! unwind_protect_cleanup
%!   cd (here);
%!   confirm_recursive_rmdir (false, 'local');
%!   rmdir (folder, 's');
%! end_unwind_protect
%! assert (value, [4; NaN; 0]);
%! assert (scale, [4; NaN; 1]);
