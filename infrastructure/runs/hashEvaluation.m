% HASHEVALUATION  Hash of what decides how a finished run is evaluated.
%
% CALL: KEY = hashEvaluation (MODEL)
%
%   MODEL  element of Case.models
%   KEY    64 hexadecimal digits: of the files of OctaveFuns and, where the case
%          has measured.csv, of which results it reads, and where on a curve
%
% A finished run with another hash is evaluated again, not simulated again.

function key = hashEvaluation (model)
  key = hashFolder (fullfile (model.folder, 'OctaveFuns'), {});
  if isfield (model, 'readings') && ~isempty (model.readings)
    r = model.readings;
    words = [{r.result}; {r.series}];
    text = sprintf ('|%s|%s', words{:});
    key = hash ('sha256', [key, text, sprintf('|%.12g', r.at)]);
  end
end

%!test
%! folder = tempname ();
%! mkdir (folder);
%! mkdir (fullfile (folder, 'OctaveFuns'));
%! writeAtomic (fullfile (folder, 'OctaveFuns', 'getResults.m'), 'x');
%! plain = struct ('folder', folder);
%! read = plain;
%! read.readings = struct ('result', 'w', 'series', 'w', 'at', {1, 2});
%! moved = read;
%! moved.readings(2).at = 3;
%! keys = {hashEvaluation(plain), hashEvaluation(read), ...
%!         hashEvaluation(moved)};
%! assert (keys{1}, hashFolder (fullfile (folder, 'OctaveFuns'), {}));
%! assert (numel (unique (keys)), 3);
%! read.readings = [];
%! assert (hashEvaluation (read), keys{1});
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
