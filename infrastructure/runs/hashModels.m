% HASHMODELS  Hashes of what decides a run besides its variables.
%
% CALL: H = hashModels (CASE)
%
%   CASE  see newCase
%   H     1 x M struct array: input (files of the model that the simulation
%         reads, number of CPUs, LIGGGHTS build), funs (files of OctaveFuns,
%         which only evaluate), defaults (values declared in data.head)
%
% A change in OctaveFuns asks for a new evaluation of finished runs, not for
% new simulations. README, sample and pictures decide nothing.
%
% See also: runKey, collectRuns

function h = hashModels (Case)
  aside = {'OctaveFuns', 'sample', 'README.md', 'README', 'picture.png', ...
           'picture.svg', 'log.liggghts', '.git'};
  build = hashBuild ();
  h = struct ('input', cell (1, numel (Case.models)), 'funs', '', ...
              'defaults', []);
  for k = 1:numel (Case.models)
    folder = Case.models(k).folder;
    text = sprintf ('%s|%d|%s', hashFolder (folder, aside), ...
                    Case.models(k).cpu, build);
    h(k).input = hash ('sha256', text);
    h(k).funs = hashFolder (fullfile (folder, 'OctaveFuns'), {});
    h(k).defaults = headDefaults (fullfile (folder, 'data.head'));
  end
end

function key = hashBuild ()
  [~, text] = system ('b=$(command -v liggghts) && sha256sum < "$b"');
  key = strtok (text);
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! h = hashModels (Case);
%! assert (numel (h), 2);
%! assert (numel (h(1).input), 64);
%! assert (isequal (h, hashModels (Case)));
%! Case.models(1).cpu = 2;
%! g = hashModels (Case);
%! assert (! isequal (g(1).input, h(1).input));
%! assert (isequal (g(2).input, h(2).input));
